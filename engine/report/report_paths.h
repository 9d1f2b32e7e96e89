#pragma once

#include <string>

#include "engine/report/walk_result.h"

namespace campuswalk::engine {

// Results name files as seen from the folder where the run was started. Reports name them as seen from the
// root of the repository, since that is what GitHub, GitLab and code review know. `start` is the first folder
// as seen from the second, such as "campus/tests"; empty in the root, or where there is no repository.

std::string path_in_repository(const std::string& start, const std::string& path);

/// A file of the run's output folder, as whoever publishes it knows it: as seen from the repository's root;
/// if the folder lies outside of the repository (`../…`), as seen from the folder, which is published by
/// itself then.
std::string published_path(const std::string& folder, const std::string& path);

/// Of the case's id, its files, and the places of its failures and diagnostics. Artifacts stay below the
/// output folder.
WalkResult with_paths_in_repository(const std::string& start, WalkResult result);

/// The inverse, for what reads reports.
WalkResult with_paths_in_run(const std::string& start, WalkResult result);

}  // namespace campuswalk::engine
