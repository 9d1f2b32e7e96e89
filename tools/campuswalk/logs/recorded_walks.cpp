#include "tools/campuswalk/logs/recorded_walks.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <stdexcept>
#include <utility>

#include "config/loader/load_run.h"
#include "engine/report/report_paths.h"
#include "engine/report/result_json.h"
#include "engine/report/walk_result.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/logs/log_lines.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

scene::InputError about_line(const fs::path& file, std::size_t line, scene::DiagnosticCode code,
                             const std::string& message) {
    return scene::InputError(scene::SourceMark{file.string(), static_cast<int>(line), 1}, code, message);
}

std::map<std::string, fs::path> by_name(const std::vector<fs::path>& files) {
    std::map<std::string, fs::path> named;
    for (const fs::path& file : files) {
        const std::string name = without_ending(file.filename().string(), config::kWalkSuffix);
        if (!named.emplace(name, file).second) {
            throw error_about(file, "duplicate-name",
                              "two walks called " + name + ": give --walk one of them");
        }
    }
    return named;
}

std::optional<std::uint64_t> hash_of(const std::string& digits) {
    std::uint64_t hash = 0;
    const char* end = digits.data() + digits.size();
    const bool read = !digits.empty() && std::from_chars(digits.data(), end, hash, 16).ptr == end;
    return read ? std::optional(hash) : std::nullopt;
}

/// nullopt if the line isn't the header of a report.
std::optional<engine::RunPlan> plan_of(const fs::path& source, const std::string& line) {
    try {
        return engine::plan_from_header_line(line);
    } catch (const std::runtime_error& error) {
        throw about_line(source, 1, "bad-report", std::string(error.what()) + "; create the report again");
    }
}

std::vector<RecordedWalk> walks_of_report(const fs::path& source, const std::string& start,
                                          const std::vector<std::string>& lines) {
    std::vector<RecordedWalk> walks;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        try {
            const engine::WalkResult result =
                engine::with_paths_in_run(start, engine::result_from_json_line(lines[i]));
            const bool ended =
                result.outcome == engine::Outcome::passed || result.outcome == engine::Outcome::failed;
            walks.push_back({result.id, result.name, result.project, result.config, result.file,
                             result.timeout, ended ? std::optional(result.hash) : std::nullopt,
                             std::string(engine::name_of(result.outcome)),
                             result.outcome == engine::Outcome::skipped, i + 1});
        } catch (const std::runtime_error& error) {
            throw about_line(source, i + 1, "no-result", error.what());
        }
    }
    return walks;
}

std::vector<RecordedWalk> walks_of_log(const fs::path& source, const std::vector<std::string>& lines,
                                       const std::vector<fs::path>& walk_files) {
    const std::map<std::string, fs::path> files = by_name(walk_files);
    std::vector<RecordedWalk> walks;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (const std::optional<LogHeader> header = log_header(lines[i])) {
            const auto file = files.find(header->walk);
            if (file == files.end()) {
                throw about_line(source, i + 1, "unknown-walk",
                                 "a log doesn't say where its walk is: add --walk .../" + header->walk +
                                     std::string(config::kWalkSuffix));
            }
            walks.push_back({"", header->walk, header->project, fs::path(), file->second, header->timeout,
                             std::nullopt, "cut short", false, i + 1});
        } else if (const std::optional<LoggedEvent> event = logged_event(lines[i]);
                   event && event->kind == "walk.end") {
            walks.back().hash = hash_of(event->hash);
        }
    }
    return walks;
}

}  // namespace

Recording recorded_walks(const fs::path& source, const std::vector<std::string>& lines,
                         const std::vector<fs::path>& walk_files) {
    const std::string first = lines.empty() ? "" : lines.front();
    if (is_log_header(first)) {
        return {walks_of_log(source, lines, walk_files), 0};
    }
    const std::optional<engine::RunPlan> plan = plan_of(source, first);
    if (!plan) {
        throw about_line(source, 1, "no-log",
                         "this is neither a log (run --jsonl FILE) nor a report (run --reporter jsonl=FILE)");
    }
    if (!walk_files.empty()) {
        throw error_about("--walk", "bad-value", "a report names its walks itself");
    }
    std::vector<RecordedWalk> walks = walks_of_report(source, plan->start, lines);
    std::set<std::string> ids;
    for (const RecordedWalk& walk : walks) {
        ids.insert(walk.id);
    }
    const std::size_t missing = plan->cases - std::min(plan->cases, ids.size());
    return {std::move(walks), missing};
}

}  // namespace campuswalk::tools
