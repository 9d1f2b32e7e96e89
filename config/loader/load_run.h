#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "config/loader/overrides.h"
#include "engine/script/walk.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::config {

/// Where files that are named without a path are looked for.
struct SearchPaths {
    std::vector<std::filesystem::path> avatars;  ///< folders with NAME.avatar.yaml, after those near the walk
    std::vector<std::filesystem::path> lights;   ///< likewise with NAME.light.yaml
};

/// A walk with the campus it names, both read and checked for form.
struct Run {
    engine::Walk walk;
    scene::CampusDescription campus;
};

/// The same, the campus shared with other walks.
struct SharedRun {
    engine::Walk walk;
    std::shared_ptr<const scene::CampusDescription> campus;
    std::filesystem::path avatar_file;  ///< empty when it names no profile
    std::vector<scene::Diagnostic> warnings;
};

using CampusDescriptions = std::map<std::string, std::shared_ptr<const scene::CampusDescription>>;

// All throw scene::InputError with every mistake of the file, and of the files it names, at once. Codes:
//   missing-file, file-name, too-large, empty-file, yaml-syntax   the file as such
//   unknown-key, missing-key, duplicate-key                       keys
//   wrong-type, bad-value                                         values
//   unknown-name, duplicate-name                                  names of places, layers, avatars, events, …
//   include-cycle, include-depth, too-many-steps                  steps that other files and rounds add

/// Reads `NAME.walk.yaml`, the campus it names and its avatar profile; resolves places and spawns.
Run load_run(const std::filesystem::path& walk_file, const SearchPaths& search);

/// Reads many walks, and every campus they name once.
class RunLoader {
public:
    explicit RunLoader(SearchPaths search) : search_(std::move(search)) {}

    /// As load_run, with some of the walk's values replaced.
    SharedRun load(const std::filesystem::path& walk_file, const Overrides& overrides = {});

    /// Reads what the values themselves name, as far as they tell it without a walk.
    void check(const Overrides& overrides);

private:
    SearchPaths search_;
    CampusDescriptions campuses_;  ///< by path as diagnostics show it
};

/// Reads `NAME.campus.yaml` alone.
scene::CampusDescription load_campus_description(const std::filesystem::path& campus_file);

/// Reads `NAME.steps.yaml` and what it includes; without a walk the names of places can't be checked.
std::vector<engine::Step> load_steps(const std::filesystem::path& steps_file);

/// Reads a camera's keys as they stand in a walk, `{view: orbit, around: library}`; diagnostics are of
/// `asked_by`. What isn't written of view, size and field of view is as in `camera`.
engine::CameraSettings read_camera_text(const std::string& text, const std::string& asked_by,
                                        const scene::CampusDescription& campus,
                                        const engine::CameraSettings& camera);

/// Reads `NAME.avatar.yaml` alone.
engine::AvatarProfile load_avatar(const std::filesystem::path& avatar_file);

/// Reads `NAME.light.yaml` alone.
engine::LightSettings load_light(const std::filesystem::path& light_file);

/// Reads a light as it may stand in a walk: a profile's name or `{profile: night, shadows: false}`. Profiles
/// are looked for near `folder`; diagnostics are of `asked_by`.
engine::LightSettings read_light_text(const std::string& text, const std::string& asked_by,
                                      const std::filesystem::path& folder, const SearchPaths& search);

}  // namespace campuswalk::config
