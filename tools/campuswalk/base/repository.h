#pragma once

#include <string>

#include "tools/campuswalk/base/environment.h"

namespace campuswalk::tools {

/// The current folder as seen from the repository's root, such as "campus/tests"; empty in the root, or
/// outside any. The root is GITHUB_WORKSPACE or CI_PROJECT_DIR, if that is the current folder or above it,
/// else the nearest folder with `.git`.
std::string start_in_repository(const Environment& environment);

}  // namespace campuswalk::tools
