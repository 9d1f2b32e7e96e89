#include "config/loader/load_run.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "config/loader/campus/geojson_points.h"
#include "config/loader/campus/read_campus.h"
#include "config/loader/profile/profile_search.h"
#include "config/loader/profile/read_light.h"
#include "config/loader/values/checked_map.h"
#include "config/loader/values/names.h"
#include "config/loader/values/yaml_file.h"
#include "config/loader/walk/avatar_reader.h"
#include "config/loader/walk/campus_names.h"
#include "config/loader/walk/read_camera.h"
#include "config/loader/walk/read_steps.h"
#include "config/loader/walk/read_walk.h"
#include "config/loader/yaml/diagnostics.h"
#include "config/loader/yaml/source_text.h"
#include "config/loader/yaml/yaml_tree.h"
#include "engine/script/player.h"

namespace campuswalk::config {

namespace fs = std::filesystem;

using engine::AvatarProfile;
using scene::CampusDescription;
using scene::DiagnosticList;
using scene::SourceMark;

namespace {

SourceMark whole_file(const fs::path& file) {
    return {shown_path(file), 0, 0};
}

/// `named_at` is where the file is named: in another file, or the file itself if the user named it.
std::optional<CampusDescription> open_campus(const fs::path& path, const ReadRoots& roots,
                                             const SourceMark& named_at, DiagnosticList& diagnostics) {
    const auto file = YamlFile::open(path, ".campus.yaml", roots, named_at, diagnostics);
    if (!file) {
        return std::nullopt;
    }
    CampusDescription campus = read_campus(file->root(), path.parent_path(), roots);
    campus.name = file->name();
    campus.mark = file->mark();
    return campus;
}

engine::LightSettings open_light(const fs::path& path, const ReadRoots& roots, const SourceMark& named_at,
                                 DiagnosticList& diagnostics) {
    engine::LightSettings light;
    if (const auto file = YamlFile::open(path, ".light.yaml", roots, named_at, diagnostics)) {
        CheckedMap map(file->root(), "a light");
        read_light_fields(map, light);
        map.refuse_other_keys();
    }
    return light;
}

/// Adds the profile's file to `profiles`.
engine::LightSettings named_light(const CheckedNode& node, const fs::path& folder, const SearchPaths& search,
                                  const ReadRoots& roots, std::vector<fs::path>& profiles) {
    const std::optional<std::string> name = kebab_name(node);
    const auto file =
        name ? find_profile(kLights, node, *name, profile_folders(kLights, folder, search.lights))
             : std::nullopt;
    if (!file) {
        return {};
    }
    profiles.push_back(*file);
    return open_light(*file, roots, node.mark(), node.diagnostics());
}

/// A profile's name, or a map that overrides keys of a profile (without one, of the default light).
engine::LightSettings read_light_of(const CheckedNode& node, const fs::path& folder,
                                    const SearchPaths& search, const ReadRoots& roots,
                                    std::vector<fs::path>& profiles) {
    if (node.is_scalar()) {
        return named_light(node, folder, search, roots, profiles);
    }
    if (!node.is_map()) {
        node.diagnose("wrong-type", "'light' must be a profile's name or {profile: NAME, …}");
        return {};
    }
    CheckedMap map(node, "'light'");
    const auto name = map.find("profile");
    engine::LightSettings light =
        name ? named_light(*name, folder, search, roots, profiles) : engine::LightSettings{};
    read_light_fields(map, light);
    map.refuse_other_keys();
    return light;
}

/// Before a minute has been spent on it.
void check_planned_ticks(const engine::Walk& walk, DiagnosticList& diagnostics) {
    const double planned = engine::planned_seconds(walk).value_or(0.0);
    const double ticks = std::min(planned, walk.timeout.value_or(planned)) * walk.sim.ticks_per_second;
    if (ticks > static_cast<double>(walk.sim.max_ticks)) {
        diagnostics.error(walk.mark, "too-many-ticks",
                          "its steps take over " + std::to_string(walk.sim.max_ticks) +
                              " ticks, the most that are played; wait less, or lower 'ticks_per_second'");
    }
}

/// Reads a walk and the files that it names.
class RunReader {
public:
    RunReader(const fs::path& walk_file, const SearchPaths& search, const ReadRoots& roots,
              const Overrides& overrides, CampusDescriptions& campuses, DiagnosticList& diagnostics)
        : walk_file_(walk_file),
          folder_(walk_file.parent_path()),
          search_(search),
          roots_(roots),
          overrides_(overrides),
          campuses_(campuses),
          diagnostics_(diagnostics) {}

    SharedRun read(const YamlFile& file) {
        CheckedMap map(file.root(), "a walk");
        SharedRun run;
        run.campus = read_campus_of(map, run.walk);
        const CampusNames names(run.campus.get());
        const AvatarReader avatars = avatars_near(folder_, names);
        const auto avatar = map.find("avatar");
        if (overrides_.avatar) {
            run.walk.avatar =
                avatars_near(overrides_.avatar.folder, names).read(node_of(overrides_.avatar, "'avatar'"));
        } else if (avatar) {
            run.walk.avatar = avatars.read(*avatar);
        }
        if (const auto light = map.find("light")) {
            run.walk.light = read_light_of(*light, folder_, search_, roots_, profiles_);
        }
        read_walk(map, {names, avatars}, walk_file_, roots_, run.walk);
        map.refuse_other_keys();
        replace_spawn(names, run.walk);
        run.profiles = std::move(profiles_);
        return run;
    }

    void check() {
        engine::Walk walk;
        std::shared_ptr<const CampusDescription> campus;
        if (overrides_.campus) {
            campus = campus_of(node_of(overrides_.campus, "'campus'"), overrides_.campus.folder, walk);
        }
        const CampusNames names(campus.get());
        if (overrides_.avatar) {
            avatars_near(overrides_.avatar.folder, names).read(node_of(overrides_.avatar, "'avatar'"));
        }
        if (overrides_.spawn) {
            names.spawn(node_of(overrides_.spawn, "'spawn'"));
        }
    }

private:
    AvatarReader avatars_near(const fs::path& folder, const CampusNames& names) {
        return {folder, search_.avatars, roots_, names, profiles_};
    }

    CheckedNode node_of(const Override& override_value, std::string what) {
        return {*override_value.node, std::move(what), override_value.file, diagnostics_};
    }

    std::shared_ptr<const CampusDescription> read_campus_of(CheckedMap& map, engine::Walk& walk) {
        const auto own = map.require("campus");
        if (overrides_.campus) {
            return campus_of(node_of(overrides_.campus, "'campus'"), overrides_.campus.folder, walk);
        }
        return own ? campus_of(*own, folder_, walk) : nullptr;
    }

    std::shared_ptr<const CampusDescription> campus_of(const CheckedNode& node, const fs::path& folder,
                                                       engine::Walk& walk) {
        const auto written = node.line();
        if (!written) {
            return nullptr;
        }
        walk.campus = folder / *written;
        std::shared_ptr<const CampusDescription> campus = description_of(walk.campus, node.mark());
        walk.campus_name = campus ? campus->name : "";
        return campus;
    }

    /// Only campuses without errors are cached: the errors of the others are reported for each walk.
    std::shared_ptr<const CampusDescription> description_of(const fs::path& path,
                                                            const SourceMark& named_at) {
        const std::pair key(shown_path(path), roots_.project().string());
        if (const auto cached = campuses_.find(key); cached != campuses_.end()) {
            return cached->second;
        }
        DiagnosticList campus_diagnostics;
        std::optional<CampusDescription> campus = open_campus(path, roots_, named_at, campus_diagnostics);
        diagnostics_.append(campus_diagnostics.all());
        if (!campus) {
            return nullptr;
        }
        auto shared = std::make_shared<const CampusDescription>(std::move(*campus));
        if (!campus_diagnostics.has_errors()) {
            campuses_.emplace(key, shared);
        }
        return shared;
    }

    void replace_spawn(const CampusNames& names, engine::Walk& walk) {
        auto* spawn = walk.steps.empty() ? nullptr : std::get_if<engine::SpawnStep>(&walk.steps.front());
        if (!overrides_.spawn || spawn == nullptr) {
            return;
        }
        const CheckedNode node = node_of(overrides_.spawn, "'spawn'");
        Placement placement = names.spawn(node);
        *spawn = {node.mark(), std::move(placement.label), placement.position, placement.yaw.value_or(0.0),
                  placement.fall};
    }

    fs::path walk_file_;  ///< empty without a walk
    fs::path folder_;
    std::vector<fs::path> profiles_;
    const SearchPaths& search_;
    const ReadRoots& roots_;
    const Overrides& overrides_;
    CampusDescriptions& campuses_;
    DiagnosticList& diagnostics_;
};

}  // namespace

SharedRun RunLoader::load(const fs::path& walk_file, const Overrides& overrides) {
    DiagnosticList diagnostics;
    SharedRun run;
    const SourceMark mark = whole_file(walk_file);
    const ReadRoots roots = read_roots(walk_file, search_);
    if (const auto file = YamlFile::open(walk_file, ".walk.yaml", roots, mark, diagnostics)) {
        run = RunReader(walk_file, search_, roots, overrides, campuses_, diagnostics).read(*file);
        run.walk.name = file->name();
    }
    run.walk.mark = mark;
    if (!diagnostics.has_errors()) {
        check_planned_ticks(run.walk, diagnostics);
    }
    throw_in_order(diagnostics, mark);
    if (!engine::expects_something(run.walk)) {
        diagnostics.warning(
            mark, "expects-nothing",
            "the walk passes whatever it meets, if it comes to its end; add what you 'expect'");
    }
    run.warnings = diagnostics.all();
    return run;
}

void RunLoader::check(const Overrides& overrides) {
    DiagnosticList diagnostics;
    const fs::path config = overrides.campus ? overrides.campus.file : overrides.avatar.file;
    RunReader({}, search_, read_roots(config, search_), overrides, campuses_, diagnostics).check();
    throw_in_order(diagnostics, {});
}

Run load_run(const fs::path& walk_file, const SearchPaths& search) {
    SharedRun run = RunLoader(search).load(walk_file);
    return {std::move(run.walk), *run.campus};
}

ReadRoots read_roots(const fs::path& file, const SearchPaths& search) {
    std::vector<fs::path> more = search.roots;
    more.insert(more.end(), search.avatars.begin(), search.avatars.end());
    more.insert(more.end(), search.lights.begin(), search.lights.end());
    return {file, more, search.budget};
}

CampusDescription load_campus_description(const fs::path& campus_file, const SearchPaths& search) {
    DiagnosticList diagnostics;
    const SourceMark mark = whole_file(campus_file);
    std::optional<CampusDescription> campus =
        open_campus(campus_file, read_roots(campus_file, search), mark, diagnostics);
    throw_in_order(diagnostics, mark);
    return std::move(*campus);
}

PlacesRead read_place_file(const PlaceFile& file, const std::optional<scene::GeographicPlace>& origin,
                           const SearchPaths& search) {
    DiagnosticList diagnostics;
    const SourceMark mark = whole_file(file.path);
    const YamlNode here;
    PlacesRead read;
    PointFile points;
    points.path = file.path;
    points.name_property = file.name_property;
    for (const NamedPoint& point : read_points(points, CheckedNode(here, "the file", mark.file, diagnostics),
                                               read_roots(file.path, search), origin, read.warnings)) {
        read.positions.push_back(point.position);
    }
    throw_in_order(diagnostics, mark);
    return read;
}

std::vector<engine::Step> load_steps(const fs::path& steps_file, const SearchPaths& search) {
    DiagnosticList diagnostics;
    std::vector<engine::Step> steps;
    const SourceMark mark = whole_file(steps_file);
    const ReadRoots roots = read_roots(steps_file, search);
    if (const auto file = YamlFile::open(steps_file, ".steps.yaml", roots, mark, diagnostics)) {
        const CampusNames unknown(nullptr);
        std::vector<fs::path> profiles;
        const AvatarReader avatars(steps_file.parent_path(), search.avatars, roots, unknown, profiles);
        steps = read_standalone_steps(file->root(), {unknown, avatars}, steps_file, roots);
    }
    throw_in_order(diagnostics, mark);
    return steps;
}

engine::CameraSettings read_camera_text(const std::string& text, const std::string& source,
                                        const CampusDescription& campus,
                                        const engine::CameraSettings& camera) {
    DiagnosticList diagnostics;
    CameraKeys read;
    read.size = camera;
    if (const auto root = parse_yaml(text, source, diagnostics)) {
        CheckedMap map(CheckedNode(*root, "the camera", source, diagnostics), "a camera");
        read_camera_fields(map, CampusNames(&campus), read);
        refuse_unused_keys(map, read.settings().view);
        map.refuse_other_keys();
    }
    throw_in_order(diagnostics, {source, 0, 0});
    return read.settings();
}

AvatarProfile load_avatar(const fs::path& avatar_file, const SearchPaths& search) {
    DiagnosticList diagnostics;
    const SourceMark mark = whole_file(avatar_file);
    AvatarProfile profile = open_avatar(avatar_file, read_roots(avatar_file, search), mark, diagnostics);
    throw_in_order(diagnostics, mark);
    return profile;
}

engine::LightSettings load_light(const fs::path& light_file, const SearchPaths& search) {
    DiagnosticList diagnostics;
    const SourceMark mark = whole_file(light_file);
    engine::LightSettings light = open_light(light_file, read_roots(light_file, search), mark, diagnostics);
    throw_in_order(diagnostics, mark);
    return light;
}

engine::LightSettings read_light_text(const std::string& text, const std::string& source,
                                      const fs::path& folder, const SearchPaths& search) {
    DiagnosticList diagnostics;
    engine::LightSettings light;
    if (const auto root = parse_yaml(text, source, diagnostics)) {
        std::vector<fs::path> profiles;
        light = read_light_of(CheckedNode(*root, "'light'", source, diagnostics), folder, search,
                              read_roots(folder / "", search), profiles);
    }
    throw_in_order(diagnostics, {source, 0, 0});
    return light;
}

AvatarProfile read_avatar_text(const std::string& text, const std::string& source, const fs::path& folder,
                               const CampusDescription& campus, const SearchPaths& search) {
    DiagnosticList diagnostics;
    AvatarProfile avatar;
    if (const auto root = parse_yaml(text, source, diagnostics)) {
        std::vector<fs::path> profiles;
        const ReadRoots roots = read_roots(folder / "", search);
        const CampusNames names(&campus);
        avatar = AvatarReader(folder, search.avatars, roots, names, profiles)
                     .read(CheckedNode(*root, "'avatar'", source, diagnostics));
    }
    throw_in_order(diagnostics, {source, 0, 0});
    return avatar;
}

}  // namespace campuswalk::config
