#pragma once

#include <filesystem>

#include "config/loader/values/checked_node.h"
#include "config/loader/values/read_roots.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::config {

/// Reads a campus file's root and reports all its errors. Scene files are resolved against `folder`. An
/// object with errors still counts as declared, so that other keys may name it and one mistake yields one
/// diagnostic.
scene::CampusDescription read_campus(const CheckedNode& root, const std::filesystem::path& folder,
                                     const ReadRoots& roots);

}  // namespace campuswalk::config
