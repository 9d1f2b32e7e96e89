#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/loader/overrides.h"
#include "config/loader/values/read_roots.h"
#include "engine/script/walk.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::config {

/// What a walk's file name ends with.
inline constexpr std::string_view kWalkSuffix = ".walk.yaml";

/// Where to look for profiles, which walks name without a path.
struct SearchPaths {
    std::vector<std::filesystem::path> avatars;  ///< folders with NAME.avatar.yaml, after those near the walk
    std::vector<std::filesystem::path> lights;   ///< likewise with NAME.light.yaml
    std::vector<std::filesystem::path> roots = {};  ///< folders that files may be in besides the project
    std::shared_ptr<ReadBudget> budget = std::make_shared<ReadBudget>();  ///< shared by all that is read
};

/// A walk and the campus it names, both read and checked as far as that is possible without the models.
struct Run {
    engine::Walk walk;
    scene::CampusDescription campus;
};

/// Likewise, with a campus that other walks may share.
struct SharedRun {
    engine::Walk walk;
    std::shared_ptr<const scene::CampusDescription> campus;
    std::vector<std::filesystem::path> profiles;  ///< files of the avatar and the light, if it names some
    std::vector<scene::Diagnostic> warnings;
};

/// By path, as diagnostics show it, and by project, on which it depends what a campus may name.
using CampusDescriptions =
    std::map<std::pair<std::string, std::string>, std::shared_ptr<const scene::CampusDescription>>;

// All functions throw one scene::InputError with all errors of the file and of the files it names. Codes:
//   missing-file, file-name, too-large, empty-file, yaml-syntax   the file as a whole
//   outside-project                                               files beyond ReadRoots
//   unknown-key, missing-key, duplicate-key                       keys
//   wrong-type, bad-value                                         values
//   unknown-name, duplicate-name                                  names of places, layers, avatars, events, …
//   include-cycle, include-depth, too-many-steps                  steps from `include` and `repeat`
//   too-many-ticks                                                the walk as a whole

/// Reads `NAME.walk.yaml`, the campus it names and its avatar profile; resolves places and spawns.
Run load_run(const std::filesystem::path& walk_file, const SearchPaths& search);

/// Reads many walks, but each campus that they name only once.
class RunLoader {
public:
    explicit RunLoader(SearchPaths search) : search_(std::move(search)) {}

    /// As load_run, with some of the walk's values replaced.
    SharedRun load(const std::filesystem::path& walk_file, const Overrides& overrides = {});

    /// Checks the overrides, and the files they name, as far as that is possible without a walk.
    void check(const Overrides& overrides);

private:
    SearchPaths search_;
    CampusDescriptions campuses_;
};

/// Where files may be that are named by the file and by those that it names.
ReadRoots read_roots(const std::filesystem::path& file, const SearchPaths& search);

/// Reads `NAME.campus.yaml` alone.
scene::CampusDescription load_campus_description(const std::filesystem::path& campus_file,
                                                 const SearchPaths& search = {});

/// A file of places by itself, and the property of its features that names them.
struct PlaceFile {
    std::filesystem::path path;
    std::string name_property = "name";
};

/// The places of a file, and what was left out of it.
struct PlacesRead {
    std::vector<Eigen::Vector3d> positions;  ///< world frame, metres; without a height in the file at 0
    std::vector<scene::Diagnostic> warnings;
};

/// Reads a file of places as `places: {from: {file: FILE, name: PROPERTY}}` does, for a campus that lies
/// there on the Earth.
PlacesRead read_place_file(const PlaceFile& file, const std::optional<scene::GeographicPlace>& origin,
                           const SearchPaths& search);

/// Reads `NAME.steps.yaml` and what it includes; without a walk the names of places can't be checked.
std::vector<engine::Step> load_steps(const std::filesystem::path& steps_file, const SearchPaths& search = {});

/// Reads a camera's keys as written in a walk, such as `{view: orbit, around: library}`. View, size and field
/// of view default to those of `camera`. Diagnostics name `source` as the file.
engine::CameraSettings read_camera_text(const std::string& text, const std::string& source,
                                        const scene::CampusDescription& campus,
                                        const engine::CameraSettings& camera);

/// Reads `NAME.avatar.yaml` alone.
engine::AvatarProfile load_avatar(const std::filesystem::path& avatar_file, const SearchPaths& search = {});

/// Reads `NAME.light.yaml` alone.
engine::LightSettings load_light(const std::filesystem::path& light_file, const SearchPaths& search = {});

/// Reads a light as written in a walk: a profile's name or `{profile: night, shadows: false}`. Profiles are
/// searched for near `folder`. Diagnostics name `source` as the file.
engine::LightSettings read_light_text(const std::string& text, const std::string& source,
                                      const std::filesystem::path& folder, const SearchPaths& search);

/// Reads an avatar as written in a walk: a profile's name or `{profile: adult, speed: 1.8}`. Profiles are
/// searched for near `folder`. Diagnostics name `source` as the file.
engine::AvatarProfile read_avatar_text(const std::string& text, const std::string& source,
                                       const std::filesystem::path& folder,
                                       const scene::CampusDescription& campus, const SearchPaths& search);

}  // namespace campuswalk::config
