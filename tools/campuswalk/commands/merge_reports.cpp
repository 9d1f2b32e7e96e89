#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/loader/yaml/wording.h"
#include "engine/report/make_reporter.h"
#include "engine/report/result_json.h"
#include "scene/lint/wording.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/read_lines.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/run/plan/find_walks.h"
#include "tools/campuswalk/run/plan/plan_hash.h"
#include "tools/campuswalk/run/plan/run_options.h"
#include "tools/campuswalk/run/plan/run_settings.h"
#include "tools/campuswalk/run/results/reports.h"
#include "tools/campuswalk/run/results/verdict.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

using engine::RunPlan;
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

/// The report of one shard.
struct ShardReport {
    fs::path file;
    RunPlan plan;
    std::vector<WalkResult> results;
};

/// nullopt if the file isn't a report in JSON lines. A last line that was cut short doesn't count.
std::optional<ShardReport> read_report(const fs::path& file) {
    const std::string bytes = read_bytes(file);
    ShardReport report;
    report.file = file;
    int number = 1;
    for (std::size_t start = 0, end = 0; (end = bytes.find('\n', start)) != std::string::npos;
         start = end + 1, ++number) {
        const std::string_view line = std::string_view(bytes).substr(start, end - start);
        try {
            if (number > 1) {
                report.results.push_back(engine::result_from_json_line(line));
            } else if (const std::optional<RunPlan> plan = engine::plan_from_header_line(line)) {
                report.plan = *plan;
            } else {
                return std::nullopt;
            }
        } catch (const std::runtime_error& error) {
            throw about(file, number, std::string(error.what()) + "; create the report again");
        }
    }
    return number > 1 ? std::optional(std::move(report)) : std::nullopt;
}

std::vector<ShardReport> read_folder(const fs::path& folder) {
    std::set<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file() && entry.path().extension() == ".jsonl") {
            files.insert(entry.path());
        }
    }
    std::vector<ShardReport> reports;
    for (const fs::path& file : files) {
        if (std::optional<ShardReport> report = read_report(file)) {  // event logs may be there, too
            reports.push_back(std::move(*report));
        }
    }
    if (reports.empty()) {
        throw about(folder, 0, "there is no jsonl report in here; make some with --reporter jsonl=FILE");
    }
    return reports;
}

std::vector<ShardReport> read_input(const fs::path& input) {
    std::error_code ignored;
    if (fs::is_directory(input, ignored)) {
        return read_folder(input);
    }
    if (!fs::is_regular_file(input, ignored)) {
        throw error_about(input, "missing-file", "no such file; check the path");
    }
    std::optional<ShardReport> report = read_report(input);
    if (!report) {
        throw about(input, 1, "this isn't what --reporter jsonl=FILE writes");
    }
    return {std::move(*report)};
}

/// The shards of a run, put together again, and what is missing to it.
class Merge {
public:
    explicit Merge(const std::vector<ShardReport>& reports)
        : run_(reports.front().plan), run_file_(reports.front().file) {
        for (const ShardReport& report : reports) {
            add(report);
        }
        note_missing_shards();
        if (problems_.empty() && !has_planned_cases()) {
            note(run_file_, "other-plan", "the reports' cases aren't those that the run had planned");
        }
    }

    /// Why the reports don't prove that every planned case was evaluated.
    const std::vector<std::string>& problems() const { return problems_; }

    /// As a run in one shard would have had it.
    RunPlan plan() const {
        RunPlan plan = run_;
        plan.cases = run_.all_cases;
        plan.shard = 1;
        plan.shards = 1;
        Division division;
        for (const auto& [shard, report] : shards_) {
            for (const WalkResult& result : report.results) {
                division.add(1, result.id);
            }
        }
        plan.division = division.hash();
        return plan;
    }

    /// In the order in which a single run would have reported them.
    RunReport report() const {
        RunReport merged;
        for (const auto& [shard, report] : shards_) {
            merged.results.insert(merged.results.end(), report.results.begin(), report.results.end());
        }
        return merged;
    }

private:
    void note(const fs::path& subject, const char* code, const std::string& message) {
        problems_.push_back(
            scene::to_string({scene::Severity::error, {subject.generic_string(), 0, 0}, code, message}));
    }

    void add(const ShardReport& report) {
        const RunPlan& plan = report.plan;
        const bool same_run = plan.shards == run_.shards && plan.all_cases == run_.all_cases &&
                              plan.contents == run_.contents && plan.division == run_.division;
        const std::string shard = "shard " + std::to_string(plan.shard);
        if (!same_run || plan.shard < 1 || plan.shard > plan.shards) {
            note(report.file, "other-plan",
                 "this report is of a run of other walks or in other shards; merge those of one run");
            return;
        }
        if (report.results.size() != plan.cases) {
            note(report.file, "incomplete-report",
                 "it has " + std::to_string(report.results.size()) + " of " +
                     scene::plural(plan.cases, "result") + "; run " + shard + " again");
        }
        const auto [there, is_new] = shards_.try_emplace(plan.shard, report);
        if (!is_new) {
            note(report.file, "duplicate-shard",
                 there->second.file.generic_string() + " is a report of " + shard + ", too");
        }
    }

    void note_missing_shards() {
        constexpr std::size_t kListed = 10;
        std::vector<std::string> missing;
        for (int shard = 1; shard <= run_.shards && missing.size() < kListed; ++shard) {
            if (!shards_.contains(shard)) {
                missing.push_back(std::to_string(shard));
            }
        }
        const std::size_t count = static_cast<std::size_t>(std::max(run_.shards, 0)) - shards_.size();
        if (!missing.empty()) {
            note(run_file_, "missing-shard",
                 "the run has " + std::to_string(run_.shards) + " shards, and there is no report of " +
                     joined(missing, ", ") + (count > missing.size() ? ", …" : ""));
        }
    }

    /// Whether each shard has the cases that the plan gives it.
    bool has_planned_cases() const {
        Division division;
        std::size_t cases = 0;
        for (const auto& [shard, report] : shards_) {
            for (const WalkResult& result : report.results) {
                division.add(shard, result.id);
                ++cases;
            }
        }
        return division.hash() == run_.division && cases == run_.all_cases;
    }

    RunPlan run_;
    fs::path run_file_;  ///< the first report
    std::map<int, ShardReport> shards_;
    std::vector<std::string> problems_;
};

/// Merges the reports of a run's shards. Returns the exit code that the whole run would have had, but none
/// that means success if something is missing.
int merge_reports(const MergeOptions& options) {
    std::vector<ShardReport> inputs;
    for (const fs::path& input : options.inputs) {
        std::ranges::move(read_input(input), std::back_inserter(inputs));
    }
    const Merge merge(inputs);
    RunOptions run;
    run.reporters = options.reporters;
    run.color = options.color;
    const RunSettings settings = resolve_report_settings(run, environment_variable);
    check_targets(settings.reports);
    Reports reports(settings.reports,
                    {settings.color, false, as_seen_from_here(options.output).generic_string()}, false);
    const RunReport report = merge.report();
    reports.begin(merge.plan());
    for (const WalkResult& result : report.results) {
        reports.result(result);
    }
    reports.end(report);
    for (const std::string& problem : merge.problems()) {
        print_error_line(problem);
    }
    const int code = exit_code_for(report.results);
    return code == kPass && !merge.problems().empty() ? kExpectationFailed : code;
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
    command.footer(
        "Exit code: that of the whole run; 1 if a shard's report is missing, incomplete, there twice, or of "
        "another run.");
    command.choose(chosen, [options] { return merge_reports(*options); });
}

}  // namespace campuswalk::tools
