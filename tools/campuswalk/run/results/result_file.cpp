#include "tools/campuswalk/run/results/result_file.h"

#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "engine/report/report_paths.h"
#include "engine/report/result_json.h"
#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/walk_folder.h"
#include "tools/campuswalk/run/results/signed_line.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

/// What the lines of reports are signed for: no other signed line can stand among them.
const std::string kSignedLines = "campuswalk results\n";

scene::InputError about(const fs::path& file, int line, const std::string& message) {
    return {{file.generic_string(), line, line > 0 ? 1 : 0}, "bad-report", message};
}

scene::InputError about_line(const fs::path& file, int line, const std::exception& error) {
    return about(file, line, std::string(error.what()) + "; create the report again");
}

/// The line without its signature, which must be the key's if there is one.
std::string opened(std::string_view line, const std::string& header, const std::optional<std::string>& key,
                   const fs::path& file, int number) {
    if (key && !is_authentic(line, kSignedLines + header, *key)) {
        throw scene::InputError(
            {file.generic_string(), number, 1}, "foreign-results",
            "this line wasn't signed with CAMPUSWALK_RUN_KEY; use what runs with the same "
            "key have reported");
    }
    return has_signature(line) ? unsigned_line(line) : std::string(line);
}

std::vector<ResultFile> open_folder(const fs::path& folder, const std::optional<std::string>& key) {
    std::set<fs::path> files;
    walk_folder(folder, [&](const fs::directory_entry& entry) {
        std::error_code ignored;
        if (entry.is_regular_file(ignored) && entry.path().extension() == ".jsonl") {
            files.insert(entry.path());
        }
        return true;
    });
    std::vector<ResultFile> reports;
    for (const fs::path& file : files) {
        if (std::optional<ResultFile> report = ResultFile::open(file, key)) {  // event logs may be there, too
            reports.push_back(std::move(*report));
        }
    }
    if (reports.empty()) {
        throw about(folder, 0, "there is no jsonl report in here; make some with --reporter jsonl=FILE");
    }
    return reports;
}

}  // namespace

std::string report_line(const std::string& object, const std::string& header,
                        const std::optional<std::string>& key) {
    return key ? signed_line(object, kSignedLines + header, *key) : object;
}

std::optional<ResultFile> ResultFile::open(const fs::path& file, const std::optional<std::string>& key) {
    FileLines lines(file);
    const std::optional<std::string_view> line = lines.next();
    if (!line) {
        return std::nullopt;
    }
    ResultFile report;
    report.file_ = file;
    report.header_ = has_signature(*line) ? unsigned_line(*line) : std::string(*line);
    report.key_ = key;
    try {
        const std::optional<engine::RunPlan> plan = engine::plan_from_header_line(report.header_);
        if (!plan) {
            return std::nullopt;
        }
        report.plan_ = *plan;
    } catch (const std::runtime_error& error) {
        throw about_line(file, 1, error);
    }
    opened(*line, "", key, file, 1);
    return report;
}

engine::WalkResult ResultFile::result_of(std::string_view line, int number) const {
    const std::string object = opened(line, header_, key_, file_, number);
    try {
        return engine::with_paths_in_run(plan_.start, engine::result_from_json_line(object));
    } catch (const std::runtime_error& error) {
        throw about_line(file_, number, error);
    }
}

std::size_t ResultFile::for_each(const ResultVisitor& visit) const {
    return for_each_located([&](std::uintmax_t, engine::WalkResult&& result) { visit(std::move(result)); });
}

engine::WalkResult ResultFile::read_at(std::uintmax_t offset) const {
    FileLines lines(file_, FileLines::kUsualBlock, offset);
    return result_of(lines.next().value_or(""), 0);
}

std::size_t ResultFile::for_each_located(
    const std::function<void(std::uintmax_t offset, engine::WalkResult&& result)>& visit) const {
    FileLines lines(file_);
    lines.next();  // the header
    std::size_t count = 0;
    for (; const auto line = lines.next(); ++count) {
        visit(lines.begin(), result_of(*line, lines.number()));
    }
    return count;
}

ResultBlocks::ResultBlocks(const ResultFile& file, std::size_t block_bytes)
    : file_(&file), lines_(file.file(), block_bytes) {
    lines_.next();  // the header
}

std::optional<engine::WalkResult> ResultBlocks::next() {
    const std::optional<std::string_view> line = lines_.next();
    return line ? std::optional(file_->result_of(*line, lines_.number())) : std::nullopt;
}

std::vector<ResultFile> open_result_files(const std::vector<fs::path>& inputs,
                                          const std::optional<std::string>& key) {
    std::vector<ResultFile> files;
    for (const fs::path& input : inputs) {
        std::error_code ignored;
        if (fs::is_directory(input, ignored)) {
            for (ResultFile& report : open_folder(input, key)) {
                files.push_back(std::move(report));
            }
            continue;
        }
        std::optional<ResultFile> report = ResultFile::open(input, key);
        if (!report) {
            throw about(input, 1, "this isn't what --reporter jsonl=FILE writes");
        }
        files.push_back(std::move(*report));
    }
    return files;
}

std::vector<std::string> unsigned_lines(const fs::path& file, const std::vector<std::string>& lines,
                                        const std::optional<std::string>& key) {
    std::vector<std::string> result;
    for (const std::string& line : lines) {
        const std::string header = result.empty() ? "" : result.front();
        result.push_back(opened(line, header, key, file, static_cast<int>(result.size()) + 1));
    }
    return result;
}

std::string title_of_inputs(const std::vector<fs::path>& inputs) {
    std::string title;
    for (const fs::path& input : inputs) {
        const fs::path named = input.has_filename() ? input : input.parent_path();  // as in `shards/`
        title += (title.empty() ? "" : ", ") + named.filename().generic_string();
    }
    return title;
}

}  // namespace campuswalk::tools
