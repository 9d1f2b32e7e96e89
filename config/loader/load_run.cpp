#include "config/loader/load_run.h"

#include <algorithm>
#include <optional>

#include "config/loader/campus/read_campus.h"
#include "config/loader/profile/read_profile.h"
#include "config/loader/read_whole.h"
#include "config/loader/values/checked_map.h"
#include "config/loader/values/yaml_file.h"
#include "config/loader/walk/avatar_reader.h"
#include "config/loader/walk/campus_names.h"
#include "config/loader/walk/read_steps.h"
#include "config/loader/walk/read_walk.h"
#include "config/loader/yaml/diagnostics.h"
#include "config/loader/yaml/source_text.h"
#include "config/loader/yaml/yaml_tree.h"
#include "engine/script/player.h"

namespace campuswalk::config {

namespace fs = std::filesystem;

using scene::CampusDescription;
using scene::DiagnosticList;
using scene::SourceMark;

namespace {

/// Before a minute has been spent on it.
void check_whole(const engine::Walk& walk, DiagnosticList& diagnostics) {
    const double planned = engine::planned_seconds(walk).value_or(0.0);
    const double ticks = std::min(planned, walk.timeout.value_or(planned)) * walk.sim.ticks_per_second;
    if (ticks > static_cast<double>(walk.sim.max_ticks)) {
        diagnostics.error(walk.mark, "too-many-ticks",
                          "its steps take over " + std::to_string(walk.sim.max_ticks) +
                              " ticks, the most that are played; wait less, or lower 'ticks_per_second'");
    } else if (!engine::expects_something(walk)) {
        diagnostics.warning(
            walk.mark, "expects-nothing",
            "the walk passes whatever it meets, if it comes to its end; add what you 'expect'");
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

    Run read(const YamlFile& file) {
        CheckedMap map(file.root(), "a walk");
        Run run;
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
            run.walk.light = read_light(*light, {folder_, search_.lights, roots_, profiles_});
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
        return {{folder, search_.avatars, roots_, profiles_}, names};
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

Run RunLoader::load(const fs::path& walk_file, const Overrides& overrides) {
    return read_whole_file(
        walk_file, search_, [&](const ReadRoots& roots, const SourceMark& mark, DiagnosticList& diagnostics) {
            Run run;
            if (const auto file = YamlFile::open(walk_file, ".walk.yaml", roots, mark, diagnostics)) {
                run = RunReader(walk_file, search_, roots, overrides, campuses_, diagnostics).read(*file);
                run.walk.name = file->name();
            }
            run.walk.mark = mark;
            if (!diagnostics.has_errors()) {
                check_whole(run.walk, diagnostics);
            }
            run.warnings = diagnostics.all();
            return run;
        });
}

void RunLoader::check(const Overrides& overrides) {
    DiagnosticList diagnostics;
    const fs::path config = overrides.campus ? overrides.campus.file : overrides.avatar.file;
    RunReader({}, search_, read_roots(config, search_), overrides, campuses_, diagnostics).check();
    throw_in_order(diagnostics, {});
}

std::vector<engine::Step> load_steps(const fs::path& steps_file, const SearchPaths& search) {
    return read_whole_file(
        steps_file, search, [&](const ReadRoots& roots, const SourceMark& mark, DiagnosticList& diagnostics) {
            const auto file = YamlFile::open(steps_file, ".steps.yaml", roots, mark, diagnostics);
            if (!file) {
                return std::vector<engine::Step>();
            }
            const CampusNames unknown(nullptr);
            std::vector<fs::path> profiles;
            const AvatarReader avatars({steps_file.parent_path(), search.avatars, roots, profiles}, unknown);
            return read_standalone_steps(file->root(), {unknown, avatars}, steps_file, roots);
        });
}

}  // namespace campuswalk::config
