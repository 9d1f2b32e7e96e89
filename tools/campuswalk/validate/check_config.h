#pragma once

#include <cstddef>
#include <filesystem>

#include "tools/campuswalk/loading/walk_loader.h"

namespace campuswalk::tools {

/// Checks a walks.config.yaml and all that it names: reporters, walks and, for every project, its
/// expressions, its campus, avatar and spawn, and each walk that it plays. Returns how many projects there
/// are. Throws scene::InputError with everything that is wrong.
std::size_t check_config(WalkLoader& loader, const std::filesystem::path& file);

}  // namespace campuswalk::tools
