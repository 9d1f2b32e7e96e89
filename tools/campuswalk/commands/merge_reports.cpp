#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "config/loader/yaml/wording.h"
#include "engine/report/make_reporter.h"
#include "engine/report/result_json.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/run/plan/find_walks.h"
#include "tools/campuswalk/run/plan/run_options.h"
#include "tools/campuswalk/run/plan/run_settings.h"
#include "tools/campuswalk/run/results/reports.h"
#include "tools/campuswalk/run/results/verdict.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

using engine::RunReport;
using engine::WalkResult;
using scene::InputError;

namespace {

struct MergeOptions {
    std::vector<std::filesystem::path> inputs;  ///< jsonl reports, or folders to look for them in
    std::vector<std::string> reporters;         ///< NAME or NAME=FILE; `list` if there are none
    std::filesystem::path output = "out";       ///< folder of the images that reports name
    ColorChoice color = ColorChoice::automatic;
};

InputError about(const fs::path& file, int line, const std::string& message) {
    return InputError({file.generic_string(), line, line > 0 ? 1 : 0}, "bad-report", message);
}

class Merge {
public:
    void add(const fs::path& input) {
        std::error_code ignored;
        const std::size_t before = files_;
        if (fs::is_directory(input, ignored)) {
            add_folder(input);
            if (files_ == before) {
                throw about(input, 0,
                            "there is no jsonl report in here; make some with --reporter jsonl=FILE");
            }
        } else if (!fs::is_regular_file(input, ignored)) {
            throw error_about(input, "missing-file", "no such file; check the path");
        } else if (!add_file(input)) {
            throw about(input, 1, "this isn't what --reporter jsonl=FILE writes");
        }
    }

    /// The results in the order in which a single run would have reported them.
    RunReport report() {
        const auto key = [](const WalkResult& result) {
            return std::tie(result.file, result.project, result.repetition);
        };
        std::ranges::stable_sort(results_, {}, key);
        return {std::move(results_)};
    }

    std::size_t cases() const { return cases_; }

private:
    void add_folder(const fs::path& folder) {
        std::set<fs::path> files;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
            if (entry.is_regular_file() && entry.path().extension() == ".jsonl") {
                files.insert(entry.path());
            }
        }
        for (const fs::path& file : files) {
            add_file(file);  // event logs may be there, too
        }
    }

    /// False if the file isn't a report in JSON lines.
    bool add_file(const fs::path& file) {
        std::ifstream stream(file, std::ios::binary);
        std::string line;
        std::getline(stream, line);
        const std::optional<std::size_t> cases = engine::cases_of_header(line);
        if (!cases) {
            return false;
        }
        ++files_;
        cases_ += *cases;  // as announced; there are fewer results when the run ended early
        for (int number = 2; std::getline(stream, line); ++number) {
            add_result(file, number, line);
        }
        return true;
    }

    void add_result(const fs::path& file, int number, const std::string& line) {
        WalkResult result;
        try {
            result = engine::result_from_json_line(line);
        } catch (const std::exception& error) {
            throw about(file, number, std::string(error.what()) + "; create the report again");
        }
        if (!ids_.insert(result.id).second) {
            throw about(file, 0,
                        "another report has '" + result.id +
                            "' too; give each shard's report once, and those of one run only");
        }
        results_.push_back(std::move(result));
    }

    std::size_t files_ = 0;
    std::size_t cases_ = 0;
    std::set<std::string> ids_;
    std::vector<WalkResult> results_;
};

/// Merges the reports of a run's shards. Returns the exit code that the whole run would have had.
int merge_reports(const MergeOptions& options) {
    Merge merge;
    for (const fs::path& input : options.inputs) {
        merge.add(input);
    }
    RunOptions run;
    run.reporters = options.reporters;
    run.color = options.color;
    const RunSettings settings = resolve_report_settings(run, environment_variable);
    check_targets(settings.reports);
    Reports reports(settings.reports,
                    {settings.color, false, as_seen_from_here(options.output).generic_string()}, false);
    reports.begin(merge.cases());
    const RunReport report = merge.report();
    for (const WalkResult& result : report.results) {
        reports.result(result);
    }
    reports.end(report);
    return exit_code_for(report.results);
}

}  // namespace

void add_merge_reports(Command program, CommandAction& chosen) {
    const auto options = std::make_shared<MergeOptions>();
    Command command = program.add("merge-reports", "Merge the reports of a run's shards");
    command.option({.names = "REPORT",
                    .help = "What --reporter jsonl=FILE wrote, or folders to look for that in",
                    .value = "PATH",
                    .required = true},
                   options->inputs);
    command.option({.names = "--reporter",
                    .help = config::listed(engine::reporter_names()) +
                            "; =FILE writes it to a file; may be repeated [list]",
                    .value = "NAME[=FILE]"},
                   options->reporters);
    command.option({.names = "--output",
                    .help = "Folder of the pictures that the reports name",
                    .value = "DIR",
                    .show_default = true},
                   options->output);
    add_color(command, options->color);
    command.footer("Exit code: that of the whole run.");
    command.choose(chosen, [options] { return merge_reports(*options); });
}

}  // namespace campuswalk::tools
