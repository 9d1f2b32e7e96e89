#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/loading/model_importer.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/run/html/html_reports.h"
#include "tools/campuswalk/run/plan/find_walks.h"
#include "tools/campuswalk/run/results/merged_run.h"
#include "tools/campuswalk/run/results/reports.h"
#include "tools/campuswalk/run/results/run_key.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

struct Options {
    std::vector<fs::path> inputs;  ///< jsonl reports, or folders to look for them in
    fs::path file = "report.html";
    std::string title;
    HtmlRequest html;
};

/// The new file may not replace one that it is made from.
void refuse_inputs(const Options& options, const std::vector<ResultFile>& inputs) {
    std::vector<fs::path> read = options.html.findings;
    for (const ResultFile& input : inputs) {
        read.push_back(input.file());
    }
    if (options.html.against) {
        for (const ResultFile& input :
             open_result_files({*options.html.against}, shared_run_key(environment_variable))) {
            read.push_back(input.file());
        }
    }
    require_no_input(options.file, read, "the report is made from");
}

int report(const Options& options) {
    require_html_reports("report");
    const std::vector<ResultFile> inputs =
        open_result_files(options.inputs, shared_run_key(environment_variable));
    refuse_inputs(options, inputs);
    const std::vector<ReportTarget> targets = {{"html", as_seen_from_here(options.file)}};
    check_targets(targets);
    const MergedRun merged(inputs);

    HtmlRequest request = options.html;
    request.output = as_seen_from_here(request.output);
    request.title = options.title.empty() ? title_of_inputs(options.inputs) : options.title;
    request.problems = merged.problems();
    request.start = merged.plan().start;
    engine::ReportStyle style;
    style.html = [&request](engine::TextSink sink) { return make_html_reporter(request, std::move(sink)); };
    Reports reports(targets, style, false);
    reports.begin(merged.plan());
    merged.for_each([&](engine::WalkResult&& result) { reports.result(result); });
    reports.end(engine::RunReport());

    for (const std::string& problem : merged.problems()) {
        print_error_line(problem);
    }
    print_error_line("wrote " + options.file.generic_string() +
                     (merged.problems().empty() ? "" : ", which shows what there is"));
    return merged.problems().empty() ? kPass : kBadInput;
}

}  // namespace

void add_report(Command program, CommandAction& chosen) {
    const auto options = std::make_shared<Options>();
    Command command = program.add("report", "Make an HTML report of a run");
    command.option({.names = "REPORT",
                    .help = "What --reporter jsonl=FILE wrote, of all shards, or folders to look for that in",
                    .value = "PATH",
                    .required = true},
                   options->inputs);
    command.option({.names = "-o", .help = "The report", .value = "FILE", .show_default = true},
                   options->file);
    command.option({.names = "--output",
                    .help = "Where the run's pictures, recordings and campuses are: its --output, which is "
                            "read only",
                    .value = "DIR",
                    .show_default = true},
                   options->html.output);
    command.option({.names = "--title", .help = "Of the page [the files' names]", .value = "TEXT"},
                   options->title);
    command.option({.names = "--against",
                    .help = "The jsonl report of another run: shows what changed, and where ways part",
                    .value = "PATH"},
                   options->html.against);
    command.option({.names = "--against-output", .help = "Its folder [that of --output]", .value = "DIR"},
                   options->html.against_output);
    command.option({.names = "--findings",
                    .help = "What explore --json wrote of a campus, to lie over it; may be repeated",
                    .value = "FILE"},
                   options->html.findings);
    add_report_geometry(command, options->html.geometry);
    add_import_options(command);
    add_root_option(command);
    command.footer(
        "Walks are shown in three dimensions if they were run with --record report, which leaves a recording "
        "of\n"
        "each and a bundle of each campus in --output; `run --reporter html=FILE` does both.\n"
        "Exit code: 0 written; 2 bad usage or input, or results are missing: then the report shows what "
        "there is.");
    command.choose(chosen, [options] { return report(*options); });
}

}  // namespace campuswalk::tools
