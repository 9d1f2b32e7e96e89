#pragma once

#include <cstddef>
#include <filesystem>

#include "tools/campuswalk/loading/walk_loader.h"

namespace campuswalk::tools {

/// Checks a walks.config.yaml and everything that it names: reporters, walks and, for every project, its
/// regular expressions, campus, avatar and spawn, and each walk that it plays. Returns the number of
/// projects. Throws scene::InputError with all errors. `warn` gets the warnings about walks that only some of
/// their projects have, with these projects' names, and those that all have, once.
std::size_t check_config(WalkLoader& loader, const std::filesystem::path& file, const WalkLoader::Warn& warn);

}  // namespace campuswalk::tools
