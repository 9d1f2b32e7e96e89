#include <map>
#include <memory>
#include <string>

#include "config/loader/yaml/wording.h"
#include "engine/report/make_reporter.h"
#include "scene/base/texts_of.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/cluster/run_on_slurm.h"
#include "tools/campuswalk/cluster/slurm_options.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/loading/model_importer.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/run/cases/records.h"
#include "tools/campuswalk/run/run_walks.h"

namespace campuswalk::tools {

namespace {

using SharedRunOptions = std::shared_ptr<RunOptions>;

constexpr Limits<int> kWorkers{1, 1024};
constexpr Limits<int> kTimes{1, 1'000'000};
constexpr Limits<int> kShards{1, 100'000};
constexpr Limits<int> kFrameWidth{16, 8192};
constexpr Limits<double> kSeconds{1e-3, 86'400.0};

void add_selection(Command& command, const SharedRunOptions& options) {
    command.option({.names = "PATH",
                    .help = "NAME.walk.yaml files, or folders to look for them in; without any, those of "
                            "walks.config.yaml or the current folder",
                    .value = "PATH"},
                   options->paths);
    command.option(
        {.names = "--config", .help = "Instead of the walks.config.yaml here or above", .value = "FILE"},
        options->config);
    command.option({.names = "-g,--grep",
                    .help = "Only walks whose 'FILE NAME TAGS' match the regular expression",
                    .value = "REGEX"},
                   options->grep);
    command.option(
        {.names = "-G,--grep-invert", .help = "Only walks where it doesn't match", .value = "REGEX"},
        options->grep_invert);
    command.option({.names = "--tag", .help = "Only walks with one of these tags", .value = "TAG"},
                   options->tags);
    command.option({.names = "--project", .help = "Only these of walks.config.yaml", .value = "NAME"},
                   options->projects);
    command.option({.names = "--shard",
                    .help = "The i-th of n parts, i from 1; without it the variables of Bazel, Slurm and "
                            "indexed jobs are used, and CAMPUSWALK_SHARD_INDEX (from 0) and _COUNT",
                    .value = "I/N"},
                   options->shard);
    command.option({.names = "--shard-times",
                    .help = "Balance the shards by the times that cases took in a run, from its "
                            "last-run.jsonl; all shards need the same file",
                    .value = "FILE"},
                   options->shard_times);
    command.flag({.names = "--last-failed", .help = "Only walks that didn't pass in the last run"},
                 options->last_failed);
    command.flag({.names = "--list", .help = "List what would be run"}, options->list);
    command.flag({.names = "--forbid-only", .help = "Refuse walks with 'status: only'"},
                 options->forbid_only);
    command.flag(
        {.names = "--strict",
         .help = "Refuse walks that are skipped, marked 'only', may fail in any way, expect nothing or what "
                 "can't fail, begin with a fall that they don't announce or have looser tolerances than the "
                 "defaults; pictures that can't be evaluated are failures"},
        options->strict);
    command.option(
        {.names = "--min-cases",
         .help = "A run of fewer walks, in all shards together, is an error; links to a walk don't count, "
                 "with --strict neither do copies",
         .value = "N"},
        options->min_cases, kTimes);
    command.flag({.names = "--pass-with-no-tests", .help = "Exit code 0 when nothing is selected"},
                 options->pass_with_no_tests);
}

void add_running(Command& command, const SharedRunOptions& options) {
    command.option(
        {.names = "-j,--workers",
         .help = "Processes that play walks or help to draw their frames; as many as there are cores",
         .value = "N"},
        options->workers, kWorkers);
    command.flag({.names = "-x", .help = "Stop at the first failure"}, options->stop_at_first);
    command.option({.names = "--max-failures", .help = "Stop after N failures", .value = "N"},
                   options->max_failures, kTimes);
    command.option({.names = "--repeat-each", .help = "Play every walk N times", .value = "N"},
                   options->repeat_each, kTimes);
    command.flag({.names = "--require-identical", .help = "Repetitions that differ are failures"},
                 options->require_identical);
    add_tree(command, options->tree);
    command.option(
        {.names = "--timeout",
         .help = "Simulated seconds that a walk may take at most, even if its own timeout is longer",
         .value = "SECONDS"},
        options->timeout, kSeconds);
    command.option({.names = "--kill-after",
                    .help = "Seconds of wall clock after which a walk is stopped, with exit code 3 (3600)",
                    .value = "SECONDS"},
                   options->kill_after, kSeconds);
    command.choice_flag(
        {.names = "--resume", .help = "Continue a run that was killed; with auto, start anew where none was"},
        "required", {{"required", Resume::required}, {"auto", Resume::automatic}}, options->resume);
    command.flag({.names = "--watch", .help = "Whenever a file changes, run the walks that use it"},
                 options->watch);
}

/// Frames at a fixed interval; options for what is made of them imply one.
void add_sequence(Command& command, SequenceRequest& request) {
    command.option(
        {.names = "--every",
         .help = "Draw a frame every SECONDS of simulated time, to frames/ in the walk's folder below "
                 "--output",
         .value = "SECONDS"},
        request.every, kSeconds);
    command.flag(
        {.names = "--contact-sheet",
         .help = "All frames on one picture, contact-sheet.png; like the options below, it takes one "
                 "every 0.5 s unless --every says otherwise"},
        request.contact_sheet);
    command.choices({.names = "--animation",
                     .help = "The frames as animation.png or .gif, at most 640 pixels wide; may be repeated"},
                    scene::texts_of(kAnimationKinds, &AnimationKind::name), request.animations);
    command.flag({.names = "--video", .help = "The frames as video.mp4, if ffmpeg is installed"},
                 request.video);
    const std::map<std::string, std::optional<engine::View>> views = {
        {"first_person", engine::FirstPersonView{}},
        {"third_person", engine::ThirdPersonView{}},
        {"top", engine::TopView{}}};
    command.choice({.names = "--frame-view", .help = "View of the frames [the walk's camera]"}, views,
                   request.view);
    command.option({.names = "--frame-width",
                    .help = "Width of the frames in pixels, the height in proportion [the walk's camera]",
                    .value = "N"},
                   request.width, kFrameWidth);
}

void add_output(Command& command, const SharedRunOptions& options) {
    command.option({.names = "--output",
                    .help = "Folder for pictures, DIR/WALK/SNAPSHOT.png, and for what --last-failed and "
                            "--resume need [out]",
                    .value = "DIR"},
                   options->output);
    command.option({.names = "--save",
                    .help = "Where results are saved for --last-failed, --resume and --shard-times "
                            "[DIR/last-run.jsonl]",
                    .value = "FILE"},
                   options->save);
    command.option(
        {.names = "--reporter",
         .help = config::listed(engine::reporter_names()) +
                 " or log; =FILE writes it to a file; may be repeated. Default: those of walks.config.yaml, "
                 "else the log of a single walk, a list of several",
         .value = "NAME[=FILE]"},
        options->reporters);
    command.option({.names = "--log", .help = "Write the event log to this file too", .value = "FILE"},
                   options->log);
    command.option({.names = "--jsonl", .help = "Write the events as JSON lines", .value = "FILE"},
                   options->jsonl);
    command.choices(
        {.names = "--record",
         .help =
             "Keep every tick below --output: for html reports as recordings/WALK.recording.json, and in the "
             "walk's folder its position as trajectory.csv or .tum, its costs as trace.json, for Chrome's "
             "trace viewer, or with wall time as timed-trace.json; may be repeated"},
        scene::texts_of(record_kinds(), &RecordKind::name), options->records);
    add_report_geometry(command, options->report_geometry);
    add_sequence(command, options->sequence);
    command.choice_flag({.names = "-u,--update-snapshots",
                         .help = "Which golden logs and golden images are written; alone it means changed "
                                 "[none: a missing one is a failure]"},
                        "changed", update_modes(), options->update);
    add_rendering_backend(command, options->backend);
    command.flag({.names = "-q,--quiet", .help = "Print no report and no log, only how the walks ended"},
                 options->quiet);
    command.flag({.names = "-v,--verbose", .help = "Also report on standard error how each walk ended"},
                 options->verbose);
    add_color(command, options->color);
    command.flag({.names = "--print-config", .help = "Print the settings of the run as JSON"},
                 options->print_config);
}

}  // namespace

void add_run(Command program, CommandAction& chosen) {
    const auto options = std::make_shared<RunOptions>();
    const auto slurm = std::make_shared<SlurmOptions>();
    Command command = program.add("run", "Play walks and report what happens");
    add_selection(command, options);
    add_running(command, options);
    add_output(command, options);
    add_slurm(command, *slurm);
    command.option(
        {.names = "--shards", .help = "With --slurm: into how many [64, at most one a walk]", .value = "N"},
        slurm->shards, kShards);
    add_import_options(command);
    add_root_option(command);
    command.footer(
        "Exit code: 0 all passed, 1 an expectation failed, 2 bad usage or input (nothing of that walk was "
        "run),\n"
        "3 something failed while running, 5 nothing selected, 130 interrupted.");
    command.choose(chosen, [options, slurm, command] {
        check_slurm(*slurm);
        if (!slurm->mode && slurm->shards) {
            throw error_about("--shards", "bad-value", "it needs --slurm");
        }
        return slurm->mode && !options->list && !options->print_config
                   ? run_on_slurm(*options, *slurm, command.given_except(options_of_submission()))
                   : run_walks(*options);
    });
}

}  // namespace campuswalk::tools
