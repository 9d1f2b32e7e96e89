#pragma once

#include <filesystem>

#include "config/loader/values/checked_node.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::config {

/// Reads a campus file's root into a description; complains of all its mistakes. Scene files are resolved
/// against `folder`. What could not be read is left out or at its default, but its name stays known, so that
/// one mistake gives one diagnostic.
scene::CampusDescription read_campus(const CheckedNode& root, const std::filesystem::path& folder);

}  // namespace campuswalk::config
