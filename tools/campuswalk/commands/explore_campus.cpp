#include "tools/campuswalk/commands/explore_campus.h"

#include <unistd.h>

#include <algorithm>
#include <memory>
#include <set>
#include <thread>

#include "collision/world/bullet_broad_phase.h"
#include "config/loader/load_campus.h"
#include "config/loader/load_profile.h"
#include "config/loader/load_run.h"
#include "engine/events/decimals.h"
#include "engine/walkspace/explore/campus_settings.h"
#include "engine/walkspace/passage/passage_widths.h"
#include "engine/walkspace/report/walk_report.h"
#include "scene/base/atomic_file.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/schema_line.h"
#include "tools/campuswalk/base/status_line.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/explore/avatar_text.h"
#include "tools/campuswalk/explore/cached_report.h"
#include "tools/campuswalk/explore/coverage.h"
#include "tools/campuswalk/explore/earlier_files.h"
#include "tools/campuswalk/explore/findings.h"
#include "tools/campuswalk/explore/geojson.h"
#include "tools/campuswalk/explore/minimal_walks.h"
#include "tools/campuswalk/explore/report_json.h"
#include "tools/campuswalk/explore/report_text.h"
#include "tools/campuswalk/explore/storey_plans.h"
#include "tools/campuswalk/images/images.h"
#include "tools/campuswalk/loading/cache_choice.h"
#include "tools/campuswalk/loading/campus_hash.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/run/plan/find_walks.h"

namespace campuswalk::tools {

namespace {

/// As a walk beside the campus would read it.
engine::AvatarProfile avatar_of(const std::string& text, const ExploreOptions& options,
                                const scene::CampusDescription& campus) {
    return config::read_avatar_text(text, "--avatar", options.campus.parent_path(), campus, search_paths());
}

collision::Vec3 spawn_position(const scene::CampusDescription& campus, const std::string& name) {
    std::vector<std::string> names;
    for (const scene::Spawn& spawn : campus.spawns) {
        if (spawn.name == name) {
            return spawn.position;
        }
        names.push_back(spawn.name);
    }
    throw scene::InputError(
        {kFromOption, 1, 1}, "unknown-name",
        "the campus " + campus.mark.file + " has no spawn '" + name + "'" + scene::did_you_mean(name, names));
}

bool has(const std::vector<std::string>& words, const std::string& word) {
    return std::ranges::find(words, word) != words.end();
}

std::size_t workers_of(const ExploreOptions& options) {
    return static_cast<std::size_t>(
        options.workers.value_or(static_cast<int>(std::max(1U, std::thread::hardware_concurrency()))));
}

/// Those in the files and folders of `--walks`; says how many are left out.
std::vector<engine::Walk> walks_on_campus(WalkLoader& loader, const std::filesystem::path& campus_file,
                                          const std::vector<std::filesystem::path>& paths) {
    std::error_code ignored;
    const std::filesystem::path wanted = std::filesystem::weakly_canonical(campus_file, ignored);
    std::vector<engine::Walk> walks;
    const std::vector<std::filesystem::path> files = find_walks(paths);
    for (const std::filesystem::path& file : files) {
        config::Run run = loader.read(file);
        if (run.walk.status.kind != engine::WalkStatus::Kind::skip &&
            std::filesystem::weakly_canonical(run.walk.campus, ignored) == wanted) {
            walks.push_back(loader.ready(std::move(run)).walk);
        }
    }
    if (walks.empty()) {
        throw scene::InputError({"--walks", 1, 1}, "no-walks",
                                "there are no walks on " + campus_file.generic_string());
    }
    if (const std::size_t others = files.size() - walks.size(); others > 0) {
        print_error_line("--walks: " + std::to_string(others) + (others == 1 ? " walk is" : " walks are") +
                         " left out, being skipped or on other campuses");
    }
    return walks;
}

/// A body is a capsule, which is at least as high as it is wide; one that is no wider finds nothing.
void check_width(const ExploreOptions& options, const engine::AvatarProfile& avatar) {
    const bool crouches = has(options.allow, "crouch");
    const double height = crouches ? engine::crouched_height(avatar) : avatar.height;
    const auto metres = [](double value) { return engine::fixed(value, 2) + " m"; };
    if (options.min_width > 0.0 && options.min_width <= 2.0 * avatar.radius) {
        throw scene::InputError(
            {"--min-width", 1, 1}, "bad-value",
            "the avatar is " + metres(2.0 * avatar.radius) + " wide itself; name a larger width");
    }
    if (options.min_width > height) {
        throw scene::InputError({"--min-width", 1, 1}, "bad-value",
                                "no visitor is wider than high, and this one is " + metres(height) + " high" +
                                    (crouches ? " when it crouches" : ""));
    }
}

void check_places(const ExploreOptions& options, const scene::CampusDescription& campus) {
    std::vector<std::string> names;
    for (const scene::Place& place : campus.places) {
        names.push_back(place.name);
    }
    for (const std::string& name : options.required) {
        const bool known =
            name == "all" ||
            std::ranges::any_of(campus.places, [&](const scene::Place& place) { return place.name == name; });
        if (!known) {
            throw scene::InputError({"--require", 1, 1}, "unknown-name",
                                    "the campus " + campus.mark.file + " has no place '" + name + "'" +
                                        scene::did_you_mean(name, names));
        }
    }
}

/// Before an hour is spent on what can't be written or evaluated.
void check_options(const ExploreOptions& options) {
    const auto require_name = [](const char* option, const std::optional<std::filesystem::path>& path) {
        if (path && path->empty()) {  // or it would be the current folder
            throw scene::InputError({option, 1, 1}, "bad-value", "name where to write it");
        }
    };
    require_name("--json", options.json);
    require_name("--map", options.map);
    require_name("--write-walks", options.walks);
    require_name("--geojson", options.geojson);
    if (options.fail_under && options.covered_by.empty()) {
        throw scene::InputError({"--fail-under", 1, 1}, "missing-key",
                                "it is about the walks of --walks; name some");
    }
    if (options.json) {
        require_writable_file(*options.json, "the report can't be written here");
    }
    if (options.map) {
        if (!can_draw()) {
            throw scene::InputError({"--map", 1, 1}, "no-rendering", "this build can't draw plans");
        }
        require_writable_folder(*options.map, "the plans can't be written here");
    }
    if (options.geojson) {
        require_writable_file(*options.geojson, "the map can't be written here");
    }
    if (options.walks) {
        require_writable_folder(*options.walks, "the walks can't be written here");
    }
}

std::filesystem::path plan_file(const std::filesystem::path& folder, std::size_t storey) {
    return folder / ("storey-" + std::to_string(storey) + ".png");
}

/// Refuses outputs that are files of the campus; these are known once it is loaded.
void refuse_inputs(const ExploreOptions& options, const scene::Campus& campus) {
    std::vector<std::filesystem::path> inputs = files_of(campus, options.campus);
    if (!options.covered_by.empty()) {
        const std::vector<std::filesystem::path> walks = find_walks(options.covered_by);
        inputs.insert(inputs.end(), walks.begin(), walks.end());
    }
    const char* const purpose = "the campus or its walks are read from";
    for (const std::optional<std::filesystem::path>& output : {options.json, options.geojson}) {
        if (output) {
            require_no_input(*output, inputs, purpose);
        }
    }
    if (options.map) {
        constexpr std::size_t kMostStoreys = 1000;  // more than any campus has
        for (std::size_t storey = 0; storey < kMostStoreys; ++storey) {
            require_no_input(plan_file(*options.map, storey), inputs, purpose);
        }
    }
}

/// Who walks where, and the walks whose coverage is measured.
struct Visit {
    std::shared_ptr<const scene::Campus> campus;
    engine::AvatarProfile avatar;
    std::vector<bool> disabled;  ///< by object
    std::vector<engine::Walk> walks;
};

Visit read_visit(const ExploreOptions& options) {
    WalkLoader loader;
    Visit visit;
    visit.campus = loader.load_campus(options.campus);
    refuse_inputs(options, *visit.campus);
    check_places(options, visit.campus->description);
    visit.avatar = avatar_of(options.avatar, options, visit.campus->description);
    check_width(options, visit.avatar);
    if (!options.covered_by.empty()) {
        visit.walks = walks_on_campus(loader, options.campus, options.covered_by);
    }
    visit.disabled = disabled_objects(*visit.campus, options.disable);
    return visit;
}

engine::ExploreSettings settings_for(const ExploreOptions& options, const Visit& visit) {
    const scene::Campus& campus = *visit.campus;
    engine::ExploreSettings settings =
        engine::explore_settings(campus, visit.avatar, engine::SimSettings().ticks_per_second);
    settings.solids.disabled = &visit.disabled;
    settings.max_nodes = static_cast<std::size_t>(options.max_cells);
    settings.run = has(options.allow, "run");
    settings.jump = has(options.allow, "jump");
    if (has(options.allow, "crouch")) {  // what is walked upright is walked like that, too
        settings.strides.full_height = visit.avatar.height;
        settings.strides.body.height = engine::crouched_height(visit.avatar);
    }
    if (!options.from.empty()) {
        settings.starts.clear();
        for (const std::string& name : options.from) {
            settings.starts.push_back(spawn_position(campus.description, name));
        }
    }
    if (settings.starts.empty()) {
        throw scene::InputError(campus.description.mark, "missing-key",
                                "the campus has no spawn to start from; add one under 'spawns'");
    }
    return settings;
}

/// "[####..............] 2/5": how many of its stages are done.
std::string progress_bar(const engine::ReportStage& stage) {
    constexpr int kWidth = 20;
    const auto done = static_cast<std::size_t>(kWidth * (stage.number - 1) / stage.count);
    return "[" + std::string(done, '#') + std::string(kWidth - done, '.') + "] " +
           std::to_string(stage.number) + "/" + std::to_string(stage.count);
}

/// The report, from the cache if it is there; shows how far it is meanwhile.
engine::WalkReport report_of(const ExploreOptions& options, const Visit& visit,
                             const engine::WorkerWorlds& worlds, engine::ExploreSettings settings) {
    StatusLine progress(isatty(STDERR_FILENO) == 1);
    engine::ReportStage stage;
    settings.progress = [&](std::size_t nodes) {
        progress.show(progress_bar(stage) + " explored " + std::to_string(nodes) + " places");
    };
    const scene::CacheFolder* cache = model_cache();
    const explore::ReportInputs inputs{
        cache != nullptr ? hash_of_campus(*visit.campus, options.campus, *cache) : std::nullopt,
        visit.campus->objects.size(), visit.avatar, settings, options.min_width};
    engine::WalkReport report = explore::cached_report(inputs, cache, [&] {
        return engine::report_walks(*visit.campus, visit.avatar, worlds, settings, options.min_width,
                                    [&](const engine::ReportStage& next) {
                                        stage = next;
                                        progress.show(progress_bar(stage) + " " + stage.text);
                                    });
    });
    progress.hide();
    return report;
}

/// What came of an exploration.
struct Explored {
    engine::WalkReport report;
    std::vector<explore::Finding> findings = {};
    std::vector<engine::render::StoreyPlan> plans = {};  ///< if they are wanted
    std::optional<explore::Coverage> coverage = {};      ///< if there are walks
};

std::vector<engine::render::StoreyPlan> make_plans(const ExploreOptions& options, const Visit& visit,
                                                   const engine::WorkerWorlds& worlds,
                                                   const engine::ExploreSettings& settings,
                                                   const Explored& explored) {
    explore::GroundWidths widths;
    if (options.min_width > 0.0) {
        widths = {engine::passage_widths(worlds, settings, explored.report.space, options.min_width),
                  2.0 * visit.avatar.radius, options.min_width};
    }
    return explore::storey_plans(*visit.campus, explored.report, explored.findings, widths);
}

Explored explored_by(const ExploreOptions& options, const Visit& visit,
                     const engine::ExploreSettings& settings) {
    const engine::WorkerWorlds worlds(visit.campus->world, workers_of(options),
                                      collision::make_bullet_broad_phase);
    Explored explored{report_of(options, visit, worlds, settings)};
    explored.findings = explore::find_findings(*visit.campus, explored.report);
    if (options.map) {  // before anything is written: it may be too large for plans
        explored.plans = make_plans(options, visit, worlds, settings, explored);
    }
    if (!visit.walks.empty()) {
        explored.coverage = explore::measure_coverage(*visit.campus, explored.report, visit.walks);
    }
    return explored;
}

void write_plans(const std::vector<engine::render::StoreyPlan>& plans, const std::filesystem::path& folder) {
    for (std::size_t i = 0; i < plans.size(); ++i) {
        draw_storey_plans({&plans[i], 1}, plan_file(folder, i));
    }
    explore::remove_earlier_plans(folder, plans.size());
    if (plans.empty()) {
        print_line("plans      none: nothing is reached");
    }
}

void write_walks(const ExploreOptions& options, const Visit& visit, const engine::ExploreSettings& settings,
                 const Explored& explored) {
    const scene::Campus& walked = *visit.campus;
    std::error_code ignored;
    const std::filesystem::path campus = std::filesystem::proximate(
        std::filesystem::absolute(options.campus), std::filesystem::absolute(*options.walks), ignored);
    const engine::AvatarProfile usual = avatar_of(kUsualAvatar, options, walked.description);
    const auto text_of = [&](const engine::AvatarProfile& body) {
        return explore::avatar_text(body, kUsualAvatar, usual);
    };
    const engine::AvatarProfile body =
        has(options.allow, "crouch") ? explore::crouched(visit.avatar) : visit.avatar;
    const engine::AvatarProfile wide = explore::widened(body, options.min_width);
    const explore::DraftPlayer usual_player(walked, body, options.disable);
    const explore::DraftPlayer wide_player(walked, wide, options.disable);
    engine::Strider strider(walked.world, settings.strides, settings.solids);
    const explore::WalkHeader header{campus.generic_string(), text_of(body), text_of(wide),
                                     schema_line(*options.walks / "any", kWalkSchema)};
    std::set<std::string> written;
    for (const explore::MinimalWalk& walk : explore::minimal_walks(explored.report, explored.findings, header,
                                                                   {usual_player, wide_player, strider})) {
        const std::string name = walk.name + std::string(config::kWalkSuffix);
        const std::filesystem::path file = *options.walks / name;
        if (explore::may_replace_walk(file, header.campus)) {
            scene::write_file_atomically(file, walk.yaml);
        } else {
            print_line("kept       %s: it isn't as explore writes it; rename it to get the finding's walk",
                       file.c_str());
        }
        written.insert(name);
    }
    explore::remove_earlier_walks(*options.walks, header.campus, written);
}

void write_outputs(const ExploreOptions& options, const Visit& visit, const engine::ExploreSettings& settings,
                   const Explored& explored, std::string* json) {
    if (options.json || json != nullptr) {
        const std::string text = explore::report_json(*visit.campus, explored.report, explored.findings,
                                                      explored.coverage ? &*explored.coverage : nullptr);
        if (json != nullptr) {
            *json = text;
        } else {
            scene::write_file_atomically(*options.json, text);
        }
    }
    if (options.geojson) {
        scene::write_file_atomically(
            *options.geojson, explore::report_geojson(*visit.campus, explored.report, explored.findings));
    }
    if (options.map) {
        write_plans(explored.plans, *options.map);
    }
    if (options.walks) {
        write_walks(options, visit, settings, explored);
    }
}

std::vector<std::string> required_but_unreached(const ExploreOptions& options,
                                                const engine::WalkReport& report) {
    std::vector<std::string> names;
    for (const engine::SubjectReport& entry : report.subjects) {
        const engine::Subject& subject = entry.subject;
        const bool required = subject.kind == engine::SubjectKind::place
                                  ? has(options.required, "all") || has(options.required, subject.name)
                                  : has(options.required, "all") && engine::is_destination(subject.kind);
        if (required && !subject.reached) {
            names.push_back(subject.name);
        }
    }
    return names;
}

/// What in the report isn't as the options demand, a line for each option.
std::vector<std::string> objections(const ExploreOptions& options, const Explored& explored) {
    std::vector<std::string> lines;
    if (const auto names = required_but_unreached(options, explored.report); !names.empty()) {
        lines.push_back("--require: nobody gets to " + explore::first_of(names));
    }
    for (const std::string& kind : options.fail_on) {
        std::vector<std::string> numbers;
        for (std::size_t i = 0; i < explored.findings.size(); ++i) {
            if (explore::is_of_kind(explored.findings[i], kind)) {
                numbers.push_back(std::to_string(i + 1));
            }
        }
        if (!numbers.empty()) {
            lines.push_back("--fail-on " + kind + (numbers.size() == 1 ? ": finding " : ": findings ") +
                            explore::first_of(numbers));
        }
    }
    if (options.fail_under && 100.0 * explored.coverage->share < *options.fail_under) {
        lines.push_back("--fail-under " + engine::fixed(*options.fail_under, 1) + ": the walks visit " +
                        engine::fixed(100.0 * explored.coverage->share, 1) + " %");
    }
    return lines;
}

/// What --max-cells left out; empty if that is nothing.
std::string left_out(const engine::WalkSpace& space) {
    const std::string explored =
        std::to_string(space.node_count()) + " cells, " + engine::fixed(space.area(), 1) + " m², ";
    if (space.is_cut_by(engine::Bound::nodes)) {  // what isn't reached may lie beyond
        return explored + "were explored, and there are more; raise it, or start elsewhere with --from";
    }
    if (space.is_cut_by(engine::Bound::islands)) {
        return explored + "are reached, and those that aren't are more than it allows, or more than " +
               std::to_string(engine::kMostUnreached) +
               "; raise it, or leave ground that nobody walks on out of the colliders";
    }
    return "";
}

/// Prints what isn't as the options demand; returns the exit code.
int verdict(const ExploreOptions& options, const Explored& explored) {
    const std::vector<std::string> against = objections(options, explored);
    for (const std::string& objection : against) {
        print_line("failed     %s", objection.c_str());
    }
    if (const std::string cells = left_out(explored.report.space); !cells.empty()) {
        print_line("failed     --max-cells: %s", cells.c_str());
        return kRunFailed;
    }
    return against.empty() ? kPass : kExpectationFailed;
}

}  // namespace

void check_exploration(const ExploreOptions& options) {
    const scene::CampusDescription campus = config::load_campus_description(options.campus, search_paths());
    check_places(options, campus);
    check_width(options, avatar_of(options.avatar, options, campus));
    for (const std::string& name : options.from) {
        spawn_position(campus, name);
    }
}

int explore_campus(const ExploreOptions& options, std::string* json) {
    check_options(options);
    const Visit visit = read_visit(options);
    const engine::ExploreSettings settings = settings_for(options, visit);
    const Explored explored = explored_by(options, visit, settings);
    explore::print_report(*visit.campus, explored.report, visit.avatar, explored.findings);
    if (explored.coverage) {
        explore::print_coverage(explored.report, *explored.coverage);
    }
    write_outputs(options, visit, settings, explored, json);
    return verdict(options, explored);
}

}  // namespace campuswalk::tools
