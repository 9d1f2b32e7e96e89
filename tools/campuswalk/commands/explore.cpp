#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/base/texts_of.h"
#include "scene/lint/wording.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk/cluster/explore_on_slurm.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/commands/explore_campus.h"
#include "tools/campuswalk/explore/findings.h"
#include "tools/campuswalk/loading/model_importer.h"
#include "tools/campuswalk/loading/walk_loader.h"

namespace campuswalk::tools {

namespace {

/// A line for each kind.
std::string meanings_of_findings() {
    constexpr std::size_t kWidth = 11;
    std::string lines;
    for (const explore::FindingName& finding : explore::kFindingNames) {
        std::string name = finding.name;
        name.resize(kWidth, ' ');
        lines += "  " + name + finding.meaning + "\n";
    }
    return lines;
}

/// Which campuses, and where.
struct ExploreCommand {
    ExploreOptions options;  ///< without campus and avatar
    std::vector<std::filesystem::path> campuses;
    std::vector<std::string> avatars;
    std::filesystem::path output = "out";
    SlurmOptions slurm;
    std::optional<int> only;           ///< the number of a campus with an avatar, from 1
    std::optional<std::string> merge;  ///< the array job whose reports are to be merged
};

void check_several(const ExploreOptions& options) {
    const bool files = options.map || options.walks || options.geojson || !options.covered_by.empty();
    if (files) {
        throw error_about("explore", "bad-value",
                          "--map, --write-walks, --geojson and --walks are about one campus and one avatar");
    }
}

int explore_campuses(const ExploreCommand& command, const std::vector<std::string>& arguments) {
    ExplorationRequest request{
        explorations_of(command.campuses,
                        command.avatars.empty() ? std::vector<std::string>{kUsualAvatar} : command.avatars),
        command.options.json, command.output, command.options.workers.value_or(1)};
    const auto options_of = [&](const Exploration& each) {
        ExploreOptions options = command.options;
        options.campus = each.campus;
        options.avatar = each.avatar;
        return options;
    };
    const auto explore = [&](const Exploration& each, std::string* json) {
        return explore_campus(options_of(each), json);
    };
    if (command.only) {
        if (static_cast<std::size_t>(*command.only) > request.all.size()) {
            throw error_about("--only", "bad-value",
                              "there are only " + scene::plural(request.all.size(), "exploration"));
        }
        return explore(request.all[static_cast<std::size_t>(*command.only) - 1], nullptr);
    }
    if (!command.merge && !command.slurm.mode && request.all.size() == 1) {
        return explore(request.all.front(), nullptr);
    }
    check_several(command.options);
    if (command.options.json) {
        require_writable_file(*command.options.json, "the report can't be written here");
    }
    if (command.merge) {
        return merge_explorations(request, *command.merge);
    }
    for (const Exploration& each : request.all) {  // before the first one takes an hour
        check_exploration(options_of(each));
    }
    if (command.slurm.mode) {
        return explore_on_slurm(request, command.slurm, arguments);
    }
    return explore_all(request,
                       [&](const Exploration& each, std::string& json) { return explore(each, &json); });
}

}  // namespace

void add_explore(Command program, CommandAction& chosen) {
    const auto all = std::make_shared<ExploreCommand>();
    ExploreOptions* const options = &all->options;
    Command command =
        program.add("explore", "Walk everywhere: find out where a visitor gets to, and why not elsewhere");
    command.option({.names = "CAMPUS",
                    .help = "NAME.campus.yaml; each of several is explored with each avatar",
                    .value = "FILE",
                    .required = true},
                   all->campuses);
    command.option({.names = "--avatar",
                    .help = "A profile, or as in a walk: '{profile: adult, step_height: 0.4}'; may be "
                            "repeated [adult]",
                    .value = "AVATAR"},
                   all->avatars);
    command.option({.names = kFromOption,
                    .help = "Start at this spawn only, or at those, with commas between: gate,lobby",
                    .value = "SPAWN",
                    .is_list = true},
                   options->from);
    command.choices({.names = "--allow",
                     .help = "What the visitor may do besides walking; several with commas between: run,jump",
                     .is_list = true},
                    {"run", "jump", "crouch"}, options->allow);
    add_disable(command, options->disable);
    command.option({.names = "--require",
                    .help = "Exit with 1 unless this place is reached, or those: gallery,desk; or 'all'",
                    .value = "PLACE",
                    .is_list = true},
                   options->required);
    command.choices(
        {.names = "--fail-on",
         .help = "Exit with 1 if there are such findings; several with commas between: traps,holes",
         .is_list = true},
        scene::texts_of(explore::kFindingNames, &explore::FindingName::name), options->fail_on);
    command.option({.names = "--min-width",
                    .help = "Find passages that are too narrow for a visitor of this width",
                    .value = "METRES"},
                   options->min_width, Limits<double>{0.0, 20.0});
    command.option({.names = "--max-cells",
                    .help = "Explore no more cells of 0.25 m than this, 16 for each m², nor look at more "
                            "that aren't reached, "
                            "and exit with 3 if there are more",
                    .value = "N"},
                   options->max_cells, Limits<int>{1, kMostCells});
    command.option({.names = "--walks",
                    .help = "Measure how much the walks of this file or folder visit; may be repeated",
                    .value = "PATH"},
                   options->covered_by);
    command.option({.names = "--fail-under",
                    .help = "With --walks: exit with 1 if they visit less of the reached ground",
                    .value = "PERCENT"},
                   options->fail_under, Limits<double>{0.0, 100.0});
    command.option({.names = "--json", .help = "Write the report for programs", .value = "FILE"},
                   options->json);
    command.option({.names = "--map", .help = "Draw a plan of each storey: DIR/storey-0.png", .value = "DIR"},
                   options->map);
    command.option(
        {.names = "--write-walks",
         .help = "Write a walk of two steps for each finding that walking shows; xfail until it is mended",
         .value = "DIR"},
        options->walks);
    command.option(
        {.names = "--geojson",
         .help = "Write the ground and the findings for maps; on Earth if the campus says where it is",
         .value = "FILE"},
        options->geojson);
    command.option({.names = "-j,--workers", .help = "Threads; all cores by default"}, options->workers,
                   Limits<int>{1, 256});
    add_slurm(command, all->slurm);
    command.option({.names = "--output",
                    .help = "With --slurm: folder of the job's files, DIR/slurm-explore",
                    .value = "DIR",
                    .show_default = true},
                   all->output);
    command.option({.names = "--only",
                    .help = "Of the campuses with their avatars only the N-th, as tasks of --slurm do",
                    .value = "N"},
                   all->only, Limits<int>{1, 1'000'000});
    command.option({.names = "--merge",
                    .help = "Merge the reports of this array job's tasks, as --slurm does",
                    .value = "JOB",
                    .check = why_no_job_number},
                   all->merge);
    add_import_options(command);
    add_root_option(command);
    command.footer(
        "What --fail-on looks for:\n" + meanings_of_findings() +
        "\n"
        "Exit code: 0 explored, 1 the report has what --require, --fail-on or --fail-under forbids,\n"
        "2 bad usage or input, 3 something failed on the way, or --max-cells ended it.");
    command.choose(chosen, [all, command] {
        check_slurm(all->slurm);
        return explore_campuses(*all, command.given_except(options_of_exploration()));
    });
}

}  // namespace campuswalk::tools
