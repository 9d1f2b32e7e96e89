#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "config/loader/yaml/wording.h"
#include "engine/report/make_reporter.h"
#include "engine/report/report_paths.h"
#include "scene/lint/wording.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/repository.h"
#include "tools/campuswalk/cluster/merge_of_tasks.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/run/html/html_reports.h"
#include "tools/campuswalk/run/output/output_folder.h"
#include "tools/campuswalk/run/output/shard_artifacts.h"
#include "tools/campuswalk/run/plan/find_walks.h"
#include "tools/campuswalk/run/plan/run_options.h"
#include "tools/campuswalk/run/plan/run_settings.h"
#include "tools/campuswalk/run/results/merged_run.h"
#include "tools/campuswalk/run/results/reports.h"
#include "tools/campuswalk/run/results/run_key.h"
#include "tools/campuswalk/run/results/verdict.h"

namespace campuswalk::tools {

namespace {

struct MergeOptions {
    std::vector<std::filesystem::path> inputs;       ///< jsonl reports, or folders to look for them in
    std::optional<std::filesystem::path> artifacts;  ///< instead: a folder with those of the shards' jobs
    std::vector<std::string> reporters;              ///< NAME or NAME=FILE; `list` if there are none
    std::filesystem::path output = "out";            ///< folder of the images that reports name
    std::string images_url;                ///< where the repository's files can be seen; empty: nowhere
    std::optional<std::string> slurm_job;  ///< the array whose tasks wrote the reports
    bool quiet = false;
    ColorChoice color = ColorChoice::automatic;
};

/// Says so when reports are taken without signatures though somebody meant to demand them.
std::optional<std::string> key_to_demand() {
    if (const char* value = std::getenv("CAMPUSWALK_RUN_KEY"); value != nullptr && *value == '\0') {
        diagnose({{scene::Severity::warning,
                   {},
                   "unsigned-reports",
                   "CAMPUSWALK_RUN_KEY is empty, as a secret is that a job doesn't get: "
                   "reports are taken without signatures"}});
    }
    return shared_run_key(environment_variable);
}

std::vector<ResultFile> results_of(const std::vector<ShardArtifact>& artifacts) {
    std::vector<ResultFile> results;
    for (const ShardArtifact& artifact : artifacts) {
        results.push_back(artifact.results);
    }
    return results;
}

void gather(const std::vector<ShardArtifact>& artifacts, const std::filesystem::path& output) {
    if (const std::size_t missing = gather_files(artifacts, output); missing > 0) {
        print_error_line(scene::plural(missing, "file") + " that the results name " +
                         (missing == 1 ? "isn't" : "aren't") + " in the shards' artifacts");
    }
}

/// What the shards of a run have found.
struct Shards {
    std::vector<ShardArtifact> artifacts;  ///< with --artifacts
    MergedRun run;
    std::vector<std::string> problems;  ///< for which the run can't pass
    bool has_lost_tasks = false;        ///< tasks of --slurm that didn't come to their end
};

Shards open_shards(const MergeOptions& options, const std::optional<std::string>& key) {
    if (options.slurm_job) {
        MergeOfTasks tasks = merge_of_tasks(*options.slurm_job, options.inputs, key);
        const bool has_lost_tasks = !tasks.problems.empty();
        std::vector<std::string> problems = std::move(tasks.problems);
        std::ranges::copy(tasks.run.problems(), std::back_inserter(problems));
        return {{}, std::move(tasks.run), std::move(problems), has_lost_tasks};
    }
    std::vector<ShardArtifact> artifacts;
    if (options.artifacts) {
        artifacts = open_shard_artifacts(*options.artifacts, key);
    }
    MergedRun run(options.artifacts ? results_of(artifacts) : open_result_files(options.inputs, key));
    std::vector<std::string> problems = run.problems();
    return {std::move(artifacts), std::move(run), std::move(problems)};
}

engine::ReportStyle style_of(const MergeOptions& options, const engine::RunPlan& plan, bool color) {
    engine::ReportStyle style{color, options.quiet};
    style.start = plan.start;
    style.folder = engine::path_in_repository(start_in_repository(environment_variable),
                                              as_seen_from_here(options.output).generic_string());
    style.images_url = options.images_url;
    if (!style.images_url.empty() && !style.images_url.ends_with('/')) {
        style.images_url += '/';
    }
    return style;
}

HtmlRequest html_request(const MergeOptions& options, const Shards& shards) {
    HtmlRequest html;
    html.output = as_seen_from_here(options.output);
    html.title = title_of_inputs(options.artifacts ? std::vector{*options.artifacts} : options.inputs);
    html.problems = shards.problems;
    html.start = shards.run.plan().start;
    return html;
}

/// Reports the run once more, as a whole. Returns the outcomes of its walks.
std::set<engine::Outcome> report(const MergedRun& run, Reports& reports) {
    reports.begin(run.plan());
    std::set<engine::Outcome> outcomes;
    run.for_each([&](engine::WalkResult&& result) {
        reports.result(result);
        outcomes.insert(result.outcome);
    });
    reports.end(engine::ResultSequence([&](const engine::ResultSequence::Visit& visit) {
        run.for_each([&](engine::WalkResult&& result) { visit(result); });
    }));
    return outcomes;
}

/// Merges the reports of a run's shards. Returns the exit code that the whole run would have had, but none
/// that means success if something is missing.
int merge_reports(const MergeOptions& options) {
    const std::optional<std::string> key = key_to_demand();
    const Shards shards = open_shards(options, key);
    RunOptions run;
    run.reporters = options.reporters;
    run.color = options.color;
    const RunSettings settings = resolve_report_settings(run, environment_variable);
    check_targets(settings.reports);
    std::optional<OutputFolder> output;
    if (options.artifacts) {
        output.emplace(options.output, run_key(environment_variable),
                       OutputFolder::Tolerance());  // no file of anybody else's is replaced
        gather(shards.artifacts, options.output);
    }
    const HtmlRequest html = html_request(options, shards);
    engine::ReportStyle style = style_of(options, shards.run.plan(), settings.color);
    style.html = [&html](engine::TextSink sink) { return make_html_reporter(html, std::move(sink)); };
    Reports reports(settings.reports, style, false, key);
    const std::set<engine::Outcome> outcomes = report(shards.run, reports);
    if (output) {
        output->save_list(1);
    }
    for (const std::string& problem : shards.problems) {
        print_error_line(problem);
    }
    if (shards.has_lost_tasks) {
        return kRunFailed;  // who knows what else they would have found; also if they were interrupted
    }
    const int code = exit_code_of(outcomes);
    return code == kPass && !shards.problems.empty() ? kExpectationFailed : code;
}

}  // namespace

void add_merge_reports(Command program, CommandAction& chosen) {
    const auto options = std::make_shared<MergeOptions>();
    Command command = program.add("merge-reports", "Merge the reports of a run's shards");
    command.option({.names = "REPORT",
                    .help = "What --reporter jsonl=FILE wrote, or folders to look for that in",
                    .value = "PATH"},
                   options->inputs);
    command.option(
        {.names = "--artifacts",
         .help = "Instead of reports: a folder with the artifacts of the shards' jobs, such as "
                 "campuswalk-3 with results-3.jsonl; the files that results name are copied to --output",
         .value = "DIR"},
        options->artifacts);
    command.option({.names = "--reporter",
                    .help = config::listed(engine::reporter_names()) +
                            "; =FILE writes it to a file; may be repeated [list]",
                    .value = "NAME[=FILE]"},
                   options->reporters);
    command.option({.names = "--output",
                    .help = "Folder of the pictures that the reports name, to which --artifacts copies them",
                    .value = "DIR",
                    .show_default = true},
                   options->output);
    command.option({.names = "--pictures-url",
                    .help = "Where a service shows the job's files, for the pictures of markdown reports",
                    .value = "URL",
                    .check =
                        [](const std::string& url) {
                            const bool plain = url.find_first_of(" <>\"\\\n\r\t") == std::string::npos;
                            return plain && url.starts_with("https://") ? "" : "it must begin with https://";
                        }},
                   options->images_url);
    command.option(
        {.names = "--slurm",
         .help = "What run --slurm uses: PATH is its folder, DIR/slurm, and the tasks of this array "
                 "job that didn't come to their end are errors",
         .value = "JOB",
         .check = why_no_job_number},
        options->slurm_job);
    command.flag({.names = "-q,--quiet", .help = "Print only what failed, and the counts"}, options->quiet);
    add_color(command, options->color);
    command.footer(
        "Exit code: that of the whole run; 1 if a shard's report is missing, incomplete, there twice, or of "
        "another run;\n3 if a task of --slurm didn't come to its end.");
    command.choose(chosen, [options] {
        if (options->inputs.empty() == !options->artifacts) {
            throw error_about("REPORT", "bad-value",
                              "name reports, or the folder of their artifacts with --artifacts");
        }
        return merge_reports(*options);
    });
}

}  // namespace campuswalk::tools
