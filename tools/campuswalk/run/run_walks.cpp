#include "tools/campuswalk/run/run_walks.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "engine/report/report_paths.h"
#include "scene/base/new_file.h"
#include "scene/lint/wording.h"
#include "tools/campuswalk/base/canonical_paths.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/repository.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk/images/images.h"
#include "tools/campuswalk/logs/golden_log.h"
#include "tools/campuswalk/run/cases/records.h"
#include "tools/campuswalk/run/cases/run_fingerprint.h"
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

bool is_bad(const Case& each) {
    return each.result.outcome == engine::Outcome::bad_input;
}

bool is_log(const ReportTarget& target) {
    return target.name == "log";
}

/// What the cases are read from, as far as they could be read.
std::set<fs::path> inputs_of(const Plan& plan, CanonicalPaths& canonical) {
    std::set<fs::path> inputs;
    for (const Case& each : plan.cases) {
        inputs.insert(canonical.of(each.result.file));
        if (each.walk) {
            inputs.insert(canonical.of(each.walk->walk.campus));
            for (const fs::path& file : each.walk->campus->files) {
                inputs.insert(canonical.of(file));
            }
        }
    }
    return inputs;
}

void refuse_inputs(const std::vector<ReportTarget>& targets, const std::set<fs::path>& inputs,
                   CanonicalPaths& canonical) {
    for (const ReportTarget& target : targets) {
        if (target.file && inputs.contains(canonical.of(*target.file))) {
            throw error_about(*target.file, "report-unwritable",
                              "this would replace a file that the walks are read from; name another");
        }
    }
}

/// A snapshot there could have a texture's name, or a golden image's.
void refuse_inputs_below(const fs::path& folder, const std::set<fs::path>& inputs,
                         CanonicalPaths& canonical) {
    const fs::path whole = canonical.of(folder);
    for (const fs::path& part : whole) {
        if (part.native().ends_with(".walk.yaml-snapshots")) {
            throw error_about(folder, "output-unwritable",
                              "this is a folder of golden files; choose another");
        }
    }
    const auto first = inputs.lower_bound(whole);
    if (first != inputs.end() && std::ranges::mismatch(whole, *first).in1 == whole.end()) {
        throw error_about(folder, "output-unwritable",
                          "the walks are read from files in this folder; choose another --output");
    }
}

/// Nobody names it on the command line, so that it may not be a link anywhere.
void check_golden_folder(const fs::path& folder) {
    const std::string message = "golden files can't be saved here";
    std::error_code ignored;
    if (fs::is_symlink(folder, ignored)) {
        throw error_about(folder, "output-unwritable", message + ": it is a symbolic link");
    }
    require_writable_folder(folder, message);
}

/// Those that are walked on.
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

/// A run, from the options to the exit code.
class Run {
public:
    Run(const RunOptions& options, RunSettings settings)
        : options_(options), settings_(std::move(settings)) {}

    int run() {
        images_ = will_draw(options_.backend);
        check_sequence();
        read_last_run_if_needed();
        PlanOptions selection = plan_options(options_);
        selection.ids = selected_ids();
        selection.images = images_;
        Plan plan = make_plan(settings_, std::move(selection));
        note_shard();
        require_walks(plan, settings_.min_cases);
        if (plan.summary.all_cases == 0) {
            return nothing_selected(plan);
        }
        if (options_.list) {
            print_cases(plan);
            return std::ranges::any_of(plan.cases, is_bad) ? kBadInput : kPass;
        }
        const bool bad = plan.cases.size() == 1 && is_bad(plan.cases.front());
        if (settings_.single && bad && std::ranges::all_of(settings_.reports, is_log)) {
            return kBadInput;  // which has been reported, and no report needs it
        }
        check_outputs(plan);
        const OutputFolder output(settings_.output, run_key(environment_variable),
                                  tolerated_output(settings_, plan, options_.resume && last_run_));
        const int shard = plan.summary.shard;
        const int exit_code = play(std::move(plan));
        output.save_list(shard);
        return exit_code;
    }

private:
    void check_sequence() const {
        if (options_.sequence.any() && !images_) {
            throw error_about("--every", "bad-value",
                              can_draw()
                                  ? "no pictures are drawn with --rendering-backend none"
                                  : "this build has no rendering: configure with CAMPUSWALK_RENDER=ON");
        }
        if (options_.sequence.video && !can_make_videos()) {
            throw error_about(
                "--video", "bad-value",
                "the program ffmpeg makes videos, and it isn't installed: apt-get install ffmpeg, or use "
                "--animation apng");
        }
    }

    void read_last_run_if_needed() {
        if (!options_.last_failed && !options_.resume) {
            return;
        }
        const fs::path& file = settings_.saved;
        last_run_ = read_last_run(file, run_key(environment_variable));
        if (!last_run_ && options_.resume == Resume::automatic && !options_.last_failed) {
            return;
        }
        if (!last_run_) {
            throw error_about(
                file, "missing-file",
                "there are no results of a previous run; run without --last-failed and --resume first");
        }
        if ((options_.resume || settings_.strict) && !last_run_->authentic) {
            throw error_about(file, "foreign-results",
                              "these results weren't saved on this machine, nor with the same "
                              "CAMPUSWALK_RUN_KEY; run without --resume and --last-failed");
        }
        if (options_.resume && settings_.single) {
            throw error_about("--resume", "bad-value", "a run of one walk saves no results; name none");
        }
        if (options_.resume && (options_.jsonl || std::ranges::any_of(settings_.reports, is_log))) {
            throw error_about(
                "--resume", "bad-value",
                "it can't reproduce the logs of walks that already ran; use only reports, as in --reporter "
                "list");
        }
    }

    std::optional<std::set<std::string>> selected_ids() const {
        return options_.last_failed ? std::optional(failed_ids(*last_run_)) : std::nullopt;
    }

    void note_shard() const {
        if (!settings_.shard) {
            return;
        }
        const Shard& shard = *settings_.shard;
        if (!shard.status_file.empty()) {
            scene::write_new_file(shard.status_file, "");
        }
        if (shard.from != "--shard") {
            print_error_line("shard " + std::to_string(shard.index + 1) + " of " +
                             std::to_string(shard.count) + " (" + shard.from + ")");
        }
    }

    int nothing_selected(const Plan& plan) const {
        if (options_.pass_with_no_tests) {
            return kPass;
        }
        print_error_line(plan.files == 0 ? "no *.walk.yaml was found here; name files or folders"
                                         : scene::plural(plan.files, "walk") +
                                               " found, none matches the filters; see --list");
        return kNothingSelected;
    }

    /// Reports what can't be written before the walks, not after their first minute, and before anything is
    /// overwritten.
    void check_outputs(const Plan& plan) const {
        std::vector<ReportTarget> targets = settings_.reports;
        if (options_.jsonl) {
            targets.push_back({"jsonl-log", options_.jsonl});
        }
        check_targets(targets);
        for (const ReportTarget& target : targets) {
            if (target.name == "html") {
                require_html_reports("--reporter");
            }
        }
        CanonicalPaths canonical;
        const std::set<fs::path> inputs = inputs_of(plan, canonical);
        if (!settings_.single) {
            targets.push_back({"saved results", settings_.saved});
        }
        refuse_inputs(targets, inputs, canonical);
        for (const Case& each : plan.cases) {
            refuse_inputs_below(settings_.output / each.folder, inputs, canonical);
            if (settings_.update != UpdateSnapshots::none) {
                check_golden_folder(golden_log_file(each.result.file, each.result.project).parent_path());
            }
        }
        if (images_ || !settings_.records.empty()) {  // a failure is drawn, too
            check_folders_of_walks(plan);
        }
        if (records_for_reports()) {
            require_writable_folder(settings_.output / kBundleFolder, "campuses can't be saved here",
                                    settings_.output);
        }
        if (!settings_.single) {
            require_writable_file(settings_.saved, "results can't be saved here", settings_.output);
        }
    }

    void check_folders_of_walks(const Plan& plan) const {
        const std::string message = std::string(images_ ? "pictures" : "records") + " can't be saved here";
        std::error_code ignored;
        if (fs::symlink_status(settings_.output, ignored).type() == fs::file_type::not_found) {
            require_writable_folder(settings_.output, message);  // nothing in it can be in the way
            return;
        }
        std::set<fs::path> recordings;  // many in one folder
        for (const Case& each : plan.cases) {
            if (each.walk) {
                require_writable_folder(settings_.output / each.folder, message, settings_.output);
                recordings.insert((settings_.output / report_record_file(each.folder)).parent_path());
            }
        }
        if (records_for_reports()) {
            for (const fs::path& folder : recordings) {
                require_writable_folder(folder, message, settings_.output);
            }
        }
    }

    /// Besides files and cases, what results depend on. Reports may want more recorded than the options say.
    std::string options_of_results() const {
        const SequenceRequest& sequence = options_.sequence;
        return json_text(Json{images_, settings_.strict, static_cast<int>(settings_.update),
                              options_.require_identical, options_.records, json_of(settings_.tolerance),
                              sequence.every.value_or(0.0), sequence.contact_sheet, sequence.animations,
                              sequence.video, sequence.view ? static_cast<int>(sequence.view->index()) : -1,
                              sequence.width.value_or(0)});
    }

    std::unique_ptr<LastRunWriter> open_last_run(const Plan& plan) const {
        if (settings_.single) {
            return nullptr;
        }
        const fs::path& file = settings_.saved;
        const std::string plan_hash = resume_fingerprint(plan.summary, json_text(Json(settings_.records)));
        std::string key = run_key(environment_variable);
        if (!options_.resume || !last_run_) {
            return std::make_unique<LastRunWriter>(file, plan_hash, std::move(key));
        }
        if (last_run_->plan != plan_hash) {
            throw error_about(
                file, "other-run",
                "the last run used different walks, files or options, so it can't be continued; "
                "run without --resume");
        }
        return std::make_unique<LastRunWriter>(file, *last_run_, std::move(key));
    }

    int play(Plan plan) {
        if (!images_ && options_.backend == engine::render::RenderingBackend::automatic &&
            std::ranges::any_of(plan.cases, takes_snapshots)) {
            print_error_line("this build has no rendering: snapshots are logged but not drawn");
        }
        if (const std::ptrdiff_t not_evaluated = images_ ? 0 : count_image_expectations(plan);
            not_evaluated > 0) {
            print_error_line("no pictures are drawn: " + std::to_string(not_evaluated) +
                             (not_evaluated == 1 ? " expectation about them isn't evaluated"
                                                 : " expectations about them aren't evaluated"));
        }
        plan.summary.fingerprint = run_fingerprint(plan, options_of_results());
        const std::unique_ptr<LastRunWriter> last_run = open_last_run(plan);
        const bool plays =
            std::ranges::any_of(plan.cases, [](const Case& each) { return each.walk != nullptr; });
        const bool shows =
            std::ranges::find(settings_.reports, "html", &ReportTarget::name) != settings_.reports.end();
        if (records_for_reports() && !shows) {  // an html report bundles them itself, while walks are played
            write_campus_bundles(settings_.output, campuses_of(plan), options_.report_geometry);
        }
        Reports reports(settings_.reports, report_style(plan), plays, shared_run_key(environment_variable));
        std::unique_ptr<LogOutput> events;
        if (options_.jsonl && plays) {
            events = std::make_unique<LogOutput>(false, options_.jsonl);
        }
        const std::size_t left_out = plan.left_out;
        Scheduler scheduler(std::move(plan), scheduler_settings(reports, events != nullptr), reports,
                            events.get(), last_run.get());
        if (options_.resume && last_run_) {
            scheduler.take_over(last_run_->results);
        }
        const int exit_code = scheduler.run();
        if (left_out > 0) {
            print_error_line(scene::plural(left_out, "walk") +
                             " not run, because others are marked 'status: only'");
        }
        return exit_code;
    }

    bool records_for_reports() const {
        return std::ranges::find(settings_.records, kReportRecord) != settings_.records.end();
    }

    engine::ReportStyle report_style(const Plan& plan) const {
        engine::ReportStyle style{settings_.color, options_.quiet};
        style.start = start_in_repository(environment_variable);
        style.folder =
            engine::path_in_repository(style.start, as_seen_from_here(settings_.output).generic_string());
        HtmlRequest request;
        request.start = style.start;
        request.output = settings_.output;
        request.geometry = options_.report_geometry;
        request.campuses = campuses_of(plan);
        request.title = title_of_run();
        request.command = "campuswalk run";
        for (const fs::path& path : options_.paths) {
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

    /// What the user named, which is the same on every machine.
    std::string title_of_run() const {
        std::string title;
        for (const fs::path& path : options_.paths) {
            if (path.lexically_normal() != ".") {  // which names nothing
                title += (title.empty() ? "" : ", ") + path.generic_string();
            }
        }
        return title.empty() ? "campuswalk" : title;
    }

    SchedulerSettings scheduler_settings(const Reports& reports, bool events) const {
        SchedulerSettings scheduler;
        scheduler.play.output = settings_.output;
        scheduler.play.images = images_;
        scheduler.play.strict = settings_.strict;
        scheduler.play.backend = options_.backend;
        scheduler.play.log = reports.has_log();
        scheduler.play.events = events;
        scheduler.play.records = settings_.records;
        scheduler.play.sequence = options_.sequence;
        scheduler.play.update = settings_.update;
        scheduler.play.tolerance = settings_.tolerance;
        scheduler.pool.workers = static_cast<std::size_t>(settings_.workers);
        scheduler.pool.kill_after = settings_.kill_after;
        scheduler.max_failures = settings_.max_failures;
        scheduler.require_identical = options_.require_identical;
        scheduler.print_verdicts = options_.verbose || !reports.prints_outcomes();
        scheduler.progress = !options_.quiet && isatty(STDERR_FILENO) == 1;
        scheduler.play.progress = scheduler.progress;
        return scheduler;
    }

    const RunOptions& options_;
    RunSettings settings_;
    bool images_ = false;
    std::optional<LastRun> last_run_;
};

}  // namespace

int run_walks(const RunOptions& options) {
    RunSettings settings = resolve_settings(options, environment_variable);
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
            return Run(options, std::move(again)).run();
        });
    }
    return Run(options, std::move(settings)).run();
}

}  // namespace campuswalk::tools
