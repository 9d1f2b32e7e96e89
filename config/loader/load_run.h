#pragma once

#include <filesystem>
#include <vector>

#include "engine/script/walk.h"
#include "scene/campus_description.h"

namespace campuswalk::config {

/// Where files that are named without a path are looked for.
struct SearchPaths {
    std::vector<std::filesystem::path> avatars;  ///< folders with NAME.avatar.yaml, after those near the walk
};

/// A walk with the campus it names, both read and checked for form.
struct Run {
    engine::Walk walk;
    scene::CampusDescription campus;
};

// All throw scene::InputError with every mistake of the file, and of the files it names, at once. Codes:
//   missing-file, file-name, too-large, empty-file, yaml-syntax   the file as such
//   unknown-key, missing-key, duplicate-key                       keys
//   wrong-type, bad-value                                         values
//   unknown-name, duplicate-name                                  names of places, layers, avatars, events, …
//   include-cycle, include-depth, too-many-steps                  steps that other files and rounds add

/// Reads `NAME.walk.yaml`, the campus it names and its avatar profile; resolves places and spawns.
Run load_run(const std::filesystem::path& walk_file, const SearchPaths& search);

/// Reads `NAME.campus.yaml` alone.
scene::CampusDescription load_campus_description(const std::filesystem::path& campus_file);

/// Reads `NAME.steps.yaml` and what it includes; without a walk the names of places can't be checked.
std::vector<engine::Step> load_steps(const std::filesystem::path& steps_file);

/// Reads `NAME.avatar.yaml` alone.
engine::AvatarProfile load_avatar(const std::filesystem::path& avatar_file);

}  // namespace campuswalk::config
