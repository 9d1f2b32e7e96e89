#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "config/loader/values/read_roots.h"

namespace campuswalk::config {

// Whatever loads a file throws one scene::InputError with all errors of the file and of the files it names.
// Codes:
//   missing-file, file-name, too-large, empty-file, yaml-syntax   the file as a whole
//   outside-project                                               files beyond ReadRoots
//   unknown-key, missing-key, duplicate-key                       keys
//   wrong-type, bad-value                                         values
//   unknown-name, duplicate-name                                  names of places, layers, avatars, events, …
//   include-cycle, include-depth, too-many-steps                  steps from `include` and `repeat`
//   too-many-ticks                                                the walk as a whole

/// Where to look for profiles, which walks name without a path.
struct SearchPaths {
    std::vector<std::filesystem::path> avatars;  ///< folders with NAME.avatar.yaml, after those near the walk
    std::vector<std::filesystem::path> lights;   ///< folders with NAME.light.yaml, after those near the walk
    std::vector<std::filesystem::path> roots = {};  ///< folders that files may be in besides the project
    std::shared_ptr<ReadBudget> budget = std::make_shared<ReadBudget>();  ///< shared by all that is read
};

/// Where files may be that are named by the file and by those that it names.
inline ReadRoots read_roots(const std::filesystem::path& file, const SearchPaths& search) {
    std::vector<std::filesystem::path> more = search.roots;
    more.insert(more.end(), search.avatars.begin(), search.avatars.end());
    more.insert(more.end(), search.lights.begin(), search.lights.end());
    return {file, more, search.budget};
}

}  // namespace campuswalk::config
