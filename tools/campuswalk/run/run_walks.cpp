#include "tools/campuswalk/run/run_walks.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "engine/report/make_reporter.h"
#include "engine/report/report_paths.h"
#include "scene/base/new_file.h"
#include "scene/lint/wording.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/repository.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/images/images.h"
#include "tools/campuswalk/run/cases/records.h"
#include "tools/campuswalk/run/cases/run_fingerprint.h"
#include "tools/campuswalk/run/check_outputs.h"
#include "tools/campuswalk/run/html/html_reports.h"
#include "tools/campuswalk/run/output/output_folder.h"
#include "tools/campuswalk/run/output/tolerated_output.h"
#include "tools/campuswalk/run/plan/find_walks.h"
#include "tools/campuswalk/run/plan/plan.h"
#include "tools/campuswalk/run/plan/run_settings.h"
#include "tools/campuswalk/run/results/background_reporter.h"
#include "tools/campuswalk/run/results/last_run.h"
#include "tools/campuswalk/run/results/reports.h"
#include "tools/campuswalk/run/results/run_key.h"
#include "tools/campuswalk/run/scheduler.h"
#include "tools/campuswalk/run/watch.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

bool takes_snapshots(const Case& each) {
    return each.walk && std::ranges::any_of(each.walk->walk.steps, [](const engine::Step& step) {
               return std::holds_alternative<engine::SnapshotStep>(step);
           });
}

std::ptrdiff_t count_image_expectations(const Plan& plan) {
    std::ptrdiff_t count = 0;
    for (const Case& each : plan.cases) {
        count += each.walk ? std::ranges::count_if(each.walk->walk.expectations, engine::is_about_images) : 0;
    }
    return count;
}

bool is_log(const ReportTarget& target) {
    return target.name == "log";
}

bool is_bad(const Case& each) {
    return each.result.outcome == engine::Outcome::bad_input;
}

void check_sequence(const SequenceRequest& sequence, bool images) {
    if (sequence.any() && !images) {
        throw error_about("--every", "bad-value",
                          can_draw() ? "no pictures are drawn with --rendering-backend none"
                                     : "this build has no rendering: configure with CAMPUSWALK_RENDER=ON");
    }
    if (sequence.video && !can_make_videos()) {
        throw error_about(
            "--video", "bad-value",
            "the program ffmpeg makes videos, and it isn't installed: apt-get install ffmpeg, or use "
            "--animation apng");
    }
}

/// The results that `--last-failed` selects from or `--resume` goes on with.
std::optional<LastRun> read_earlier_run(const RunOptions& options, const RunSettings& settings) {
    if (!options.last_failed && !options.resume) {
        return std::nullopt;
    }
    const fs::path& file = settings.saved;
    std::optional<LastRun> earlier = read_last_run(file, run_key(environment_variable));
    if (!earlier && options.resume == Resume::automatic && !options.last_failed) {
        return std::nullopt;
    }
    if (!earlier) {
        throw error_about(
            file, "missing-file",
            "there are no results of a previous run; run without --last-failed and --resume first");
    }
    if ((options.resume || settings.strict) && !earlier->authentic) {
        throw error_about(file, "foreign-results",
                          "these results weren't saved on this machine, nor with the same "
                          "CAMPUSWALK_RUN_KEY; run without --resume and --last-failed");
    }
    if (options.resume && settings.single) {
        throw error_about("--resume", "bad-value", "a run of one walk saves no results; name none");
    }
    if (options.resume && (options.jsonl || std::ranges::any_of(settings.reports, is_log))) {
        throw error_about(
            "--resume", "bad-value",
            "it can't reproduce the logs of walks that already ran; use only reports, as in --reporter "
            "list");
    }
    return earlier;
}

void note_shard(const std::optional<Shard>& shard) {
    if (!shard) {
        return;
    }
    if (!shard->status_file.empty()) {
        scene::write_new_file(shard->status_file, "");
    }
    if (shard->from != "--shard") {
        print_error_line("shard " + std::to_string(shard->index + 1) + " of " + std::to_string(shard->count) +
                         " (" + shard->from + ")");
    }
}

int nothing_selected(const RunOptions& options, const PlanOptions& selection, const Plan& plan) {
    if (options.pass_with_no_tests) {
        return kPass;
    }
    if (selection.ids && selection.ids->empty()) {
        print_error_line("no walk failed in the last run, so that --last-failed has nothing to run");
        return kNothingSelected;
    }
    print_error_line(plan.files == 0 ? "no *.walk.yaml was found here; name files or folders"
                                     : scene::plural(plan.files, "walk") +
                                           " found, none matches the filters; see --list");
    return kNothingSelected;
}

/// Besides files and cases, what results depend on. Reports may want more recorded than the options say.
std::string options_of_results(const RunOptions& options, const RunSettings& settings, bool images) {
    const SequenceRequest& sequence = options.sequence;
    return json_text(Json{images, settings.strict, static_cast<int>(settings.update),
                          options.require_identical, options.records, json_of(settings.tolerance),
                          sequence.every.value_or(0.0), sequence.contact_sheet, sequence.animations,
                          sequence.video, sequence.view ? static_cast<int>(sequence.view->index()) : -1,
                          sequence.width.value_or(0)});
}

/// Null for a single walk, whose results aren't saved.
std::unique_ptr<LastRunWriter> open_last_run(const RunSettings& settings, const Plan& plan,
                                             const LastRun* continued) {
    if (settings.single) {
        return nullptr;
    }
    const fs::path& file = settings.saved;
    const std::string plan_hash = resume_fingerprint(plan.summary, json_text(Json(settings.records)));
    std::string key = run_key(environment_variable);
    if (continued == nullptr) {
        return std::make_unique<LastRunWriter>(file, plan_hash, std::move(key));
    }
    if (continued->plan != plan_hash) {
        throw error_about(file, "other-run",
                          "the last run used different walks, files or options, so it can't be continued; "
                          "run without --resume");
    }
    return std::make_unique<LastRunWriter>(file, *continued, std::move(key));
}

SchedulerSettings scheduler_settings(const RunOptions& options, const RunSettings& settings, bool images,
                                     const Reports& reports, bool events) {
    SchedulerSettings scheduler;
    scheduler.play.output = settings.output;
    scheduler.play.images = images;
    scheduler.play.strict = settings.strict;
    scheduler.play.backend = options.backend;
    scheduler.play.log = reports.has_log();
    scheduler.play.events = events;
    scheduler.play.records = settings.records;
    scheduler.play.sequence = options.sequence;
    scheduler.play.update = settings.update;
    scheduler.play.tolerance = settings.tolerance;
    scheduler.pool.workers = static_cast<std::size_t>(settings.workers);
    scheduler.pool.kill_after = settings.kill_after;
    scheduler.max_failures = settings.max_failures;
    scheduler.require_identical = options.require_identical;
    scheduler.print_verdicts = options.verbose || !reports.prints_outcomes();
    scheduler.progress = !options.quiet && isatty(STDERR_FILENO) == 1;
    scheduler.play.progress = scheduler.progress;
    return scheduler;
}

/// Says what pictures the run leaves out.
void note_undrawn(const RunOptions& options, const Plan& plan) {
    if (options.backend == engine::render::RenderingBackend::automatic &&
        std::ranges::any_of(plan.cases, takes_snapshots)) {
        print_error_line("this build has no rendering: snapshots are logged but not drawn");
    }
    if (const std::ptrdiff_t not_evaluated = count_image_expectations(plan); not_evaluated > 0) {
        print_error_line("no pictures are drawn: " + std::to_string(not_evaluated) +
                         (not_evaluated == 1 ? " expectation about them isn't evaluated"
                                             : " expectations about them aren't evaluated"));
    }
}

/// What the user named, which is the same on every machine.
std::string title_of_run(const RunOptions& options) {
    std::string title;
    for (const fs::path& path : options.paths) {
        if (path.lexically_normal() != ".") {  // which names nothing
            title += (title.empty() ? "" : ", ") + path.generic_string();
        }
    }
    return title.empty() ? "campuswalk" : title;
}

/// The campuses that a run's cases are walked on.
CampusesByFile campuses_of(const Plan& plan) {
    CampusesByFile campuses;
    for (const Case& each : plan.cases) {
        if (each.walk) {
            campuses.try_emplace(each.walk->walk.campus.lexically_normal().generic_string(),
                                 each.walk->campus);
        }
    }
    return campuses;
}

/// How a run's reports look, and what makes those in HTML.
engine::ReportStyle report_style(const RunOptions& options, const RunSettings& settings, const Plan& plan) {
    engine::ReportStyle style{settings.color, options.quiet};
    style.start = start_in_repository(environment_variable);
    style.folder =
        engine::path_in_repository(style.start, as_seen_from_here(settings.output).generic_string());
    HtmlRequest request;
    request.start = style.start;
    request.output = settings.output;
    request.geometry = options.report_geometry;
    request.campuses = campuses_of(plan);
    request.title = title_of_run(options);
    request.command = "campuswalk run";
    for (const fs::path& path : options.paths) {
        request.command += " " + shell_word(path.generic_string());
    }
    for (const Case& each : plan.cases) {
        request.walks.emplace_back(each.result.file);
    }
    style.html = [request](engine::TextSink sink) {
        return std::make_unique<BackgroundReporter>(make_html_reporter(request, std::move(sink)));
    };
    return style;
}

/// Plays the plan's cases, and reports and saves their results; returns the exit code. `continued`: a run of
/// the same plan that was killed, if there is one to go on with.
int play(const RunOptions& options, const RunSettings& settings, Plan plan, bool images,
         const LastRun* continued) {
    if (!images) {
        note_undrawn(options, plan);
    }
    plan.summary.fingerprint = run_fingerprint(plan, options_of_results(options, settings, images));
    const std::unique_ptr<LastRunWriter> last_run = open_last_run(settings, plan, continued);
    const bool plays = std::ranges::any_of(plan.cases, [](const Case& each) { return each.walk != nullptr; });
    const bool shows =
        std::ranges::find(settings.reports, "html", &ReportTarget::name) != settings.reports.end();
    if (records_for_reports(settings.records) && !shows) {  // an html report bundles them itself
        write_campus_bundles(settings.output, campuses_of(plan), options.report_geometry);
    }
    Reports reports(settings.reports, report_style(options, settings, plan), plays,
                    shared_run_key(environment_variable));
    std::unique_ptr<LogOutput> events;
    if (options.jsonl && plays) {
        events = std::make_unique<LogOutput>(false, options.jsonl);
    }
    const std::size_t left_out = plan.left_out;
    Scheduler scheduler(std::move(plan),
                        scheduler_settings(options, settings, images, reports, events != nullptr), reports,
                        events.get(), last_run.get());
    if (continued != nullptr) {
        scheduler.take_over(continued->results);
    }
    const int exit_code = scheduler.run();
    if (left_out > 0) {
        print_error_line(scene::plural(left_out, "walk") +
                         " not run, because others are marked 'status: only'");
    }
    return exit_code;
}

int run_once(const RunOptions& options, const RunSettings& settings) {
    const bool images = will_draw(options.backend);
    check_sequence(options.sequence, images);
    const std::optional<LastRun> earlier = read_earlier_run(options, settings);
    PlanOptions selection = plan_options(options);
    selection.images = images;
    if (options.last_failed) {
        selection.ids = failed_ids(*earlier);
    }
    Plan plan = make_plan(settings, selection);
    note_shard(settings.shard);
    require_walks(plan, settings.min_cases);
    if (plan.summary.all_cases == 0) {
        return nothing_selected(options, selection, plan);
    }
    if (options.list) {
        print_cases(plan);
        return std::ranges::any_of(plan.cases, is_bad) ? kBadInput : kPass;
    }
    const bool bad = plan.cases.size() == 1 && is_bad(plan.cases.front());
    if (settings.single && bad && std::ranges::all_of(settings.reports, is_log)) {
        return kBadInput;  // which has been reported, and no report needs it
    }
    check_outputs(options, settings, plan, images);
    const LastRun* continued = options.resume && earlier ? &*earlier : nullptr;
    const OutputFolder output(settings.output, run_key(environment_variable),
                              tolerated_output(settings, plan, continued != nullptr));
    const int shard = plan.summary.shard;
    const int exit_code = play(options, settings, std::move(plan), images, continued);
    output.save_list(shard);
    return exit_code;
}

}  // namespace

int run_walks(const RunOptions& options) {
    const RunSettings settings = resolve_settings(options, environment_variable);
    if (options.print_config) {
        print_lines(to_json(settings, options));
        return kPass;
    }
    if (options.watch) {
        return watch_and_run(settings, [&](const std::vector<fs::path>& changed) {
            RunSettings again = resolve_settings(options, environment_variable);
            if (!changed.empty()) {
                again.paths = changed;
            }
            return run_once(options, again);
        });
    }
    return run_once(options, settings);
}

}  // namespace campuswalk::tools
