#pragma once

#include "scene/cache/cache_folder.h"
#include "tools/campuswalk/command_line/command.h"

namespace campuswalk::tools {

/// The cache of imported models and built trees: the folder that CAMPUSWALK_CACHE_DIR names, else
/// campuswalk/ in XDG_CACHE_HOME, else ~/.cache/campuswalk; up to CAMPUSWALK_CACHE_SIZE (such as 500M or 8G).
/// Null if it is disabled (--no-cache, a size of 0) or there is no such folder to name. Throws
/// scene::InputError for an invalid size.
const scene::CacheFolder* model_cache();

/// `--no-cache`, for commands that read models.
void add_cache_flag(Command command);

}  // namespace campuswalk::tools
