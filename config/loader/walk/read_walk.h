#pragma once

#include <filesystem>

#include "config/loader/values/checked_map.h"
#include "config/loader/values/read_roots.h"
#include "config/loader/walk/walk_names.h"
#include "engine/script/walk.h"

namespace campuswalk::config {

/// Reads the keys of a walk file other than `campus`, `avatar` and `light`, which must have been read before.
void read_walk(CheckedMap& map, const WalkNames& names, const std::filesystem::path& walk_file,
               const ReadRoots& roots, engine::Walk& walk);

}  // namespace campuswalk::config
