#pragma once

#include <filesystem>
#include <string>

#include "tools/campuswalk/base/environment.h"

namespace campuswalk::tools {

/// The current folder as seen from the repository's root, such as "campus/tests"; empty in the root, or
/// outside any. The root is GITHUB_WORKSPACE or CI_PROJECT_DIR, if that is the current folder or above it,
/// else the nearest folder with `.git`.
std::string start_in_repository(const Environment& environment);

/// The folder of a checkout that could contain this one; empty if there is none. A pull request could bring
/// files along there, such as a cache or a key, that would decide what walks see or whose results are
/// believed. A HOME that is a checkout counts as one only where CI is set.
std::filesystem::path checkout_above(const std::filesystem::path& folder, const Environment& environment);

}  // namespace campuswalk::tools
