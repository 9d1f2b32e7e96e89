#pragma once

#include "scene/cache/cache_folder.h"
#include "tools/campuswalk/command_line/command.h"

namespace campuswalk::tools {

/// Where imported models and built trees are kept: the folder that CAMPUSWALK_CACHE_DIR names, else
/// campuswalk/ in XDG_CACHE_HOME, else ~/.cache/campuswalk; up to CAMPUSWALK_CACHE_SIZE (such as 500M or 8G).
/// Null if the user wants none (--no-cache, a size of 0) or nothing says where. Throws scene::InputError for
/// a size that is none.
const scene::CacheFolder* wanted_cache();

/// `--no-cache`, for commands that read models.
void add_cache_flag(Command command);

}  // namespace campuswalk::tools
