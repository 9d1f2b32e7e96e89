#pragma once

#include <filesystem>

#include "config/loader/values/checked_map.h"
#include "config/loader/walk/campus_names.h"
#include "engine/script/walk.h"

namespace campuswalk::config {

/// Reads what a walk file says by itself, once its campus and its avatar are known: all but these two.
void read_walk(CheckedMap& map, const CampusNames& names, const std::filesystem::path& walk_file,
               engine::Walk& walk);

}  // namespace campuswalk::config
