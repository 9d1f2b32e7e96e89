#include "tools/campuswalk/run/results/result_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "engine/report/report_paths.h"
#include "engine/report/result_json.h"
#include "scene/base/diagnostic.h"
#include "scene/process/pipe.h"
#include "tools/campuswalk/base/report_diagnostics.h"
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

std::ifstream open_stream(const fs::path& file) {
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) {
        throw error_about(file, "missing-file", "no such file; check the path");
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        throw error_about(file, "missing-file", "it can't be read; check its permissions");
    }
    return stream;
}

/// False at the end, and for a last line that was cut short.
bool next_line(std::istream& stream, std::string& line) {
    return static_cast<bool>(std::getline(stream, line)) && !stream.eof();
}

/// The line without its signature, which must be the key's if there is one.
std::string opened(std::string_view line, const std::string& header, const std::optional<std::string>& key,
                   const fs::path& file, int number) {
    if (key && !is_authentic(line, kSignedLines + header, *key)) {
        throw scene::InputError(
            {file.generic_string(), number, 1}, "foreign-results",
            "this line wasn't signed with CAMPUSWALK_RUN_KEY; merge what runs with the same "
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
    std::ifstream stream = open_stream(file);
    std::string line;
    if (!next_line(stream, line)) {
        return std::nullopt;
    }
    ResultFile report;
    report.file_ = file;
    report.header_ = has_signature(line) ? unsigned_line(line) : line;
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
    opened(line, "", key, file, 1);
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
    return for_each_located([&](std::streamoff, engine::WalkResult&& result) { visit(std::move(result)); });
}

engine::WalkResult ResultFile::read_at(std::streamoff offset) const {
    std::ifstream stream = open_stream(file_);
    std::string line;
    stream.seekg(offset);
    next_line(stream, line);
    return result_of(line, 0);
}

std::size_t ResultFile::for_each_located(
    const std::function<void(std::streamoff offset, engine::WalkResult&& result)>& visit) const {
    std::ifstream stream = open_stream(file_);
    std::string line;
    next_line(stream, line);  // the header
    std::size_t count = 0;
    std::streamoff offset = stream.tellg();
    for (int number = 2; next_line(stream, line);
         ++number, ++count, offset += static_cast<std::streamoff>(line.size()) + 1) {
        visit(offset, result_of(line, number));
    }
    return count;
}

std::optional<engine::WalkResult> ResultBlocks::next() {
    std::optional<std::string_view> line = next_line();
    if (line && line_ == 1) {  // the header
        line = next_line();
    }
    if (!line) {
        block_ = std::string();
        used_ = 0;
        return std::nullopt;
    }
    return file_->result_of(*line, line_);
}

std::optional<std::string_view> ResultBlocks::next_line() {
    std::size_t searched = used_;
    while (true) {
        const std::size_t end = block_.find('\n', searched);
        if (end != std::string::npos) {
            const std::string_view line = std::string_view(block_).substr(used_, end - used_);
            used_ = end + 1;
            ++line_;
            return line;
        }
        block_.erase(0, used_);
        used_ = 0;
        searched = block_.size();
        if (!read_block()) {
            return std::nullopt;
        }
    }
}

/// Fills the block up, or makes it longer for a line that doesn't fit.
bool ResultBlocks::read_block() {
    const scene::Descriptor file(::open(file_->file().c_str(), O_RDONLY | O_CLOEXEC));
    const std::size_t before = block_.size();
    block_.resize(before < block_bytes_ / 2 ? block_bytes_ : before + block_bytes_);
    const ssize_t count =
        file.open() ? ::pread(file.number(), block_.data() + before, block_.size() - before, offset_) : -1;
    if (count < 0) {
        throw error_about(file_->file(), "missing-file",
                          "it can't be read any more: " + std::generic_category().message(errno));
    }
    block_.resize(before + static_cast<std::size_t>(count));
    offset_ += count;
    return count > 0;
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

std::string title_of_inputs(const std::vector<fs::path>& inputs) {
    std::string title;
    for (const fs::path& input : inputs) {
        const fs::path named = input.has_filename() ? input : input.parent_path();  // as in `shards/`
        title += (title.empty() ? "" : ", ") + named.filename().generic_string();
    }
    return title;
}

}  // namespace campuswalk::tools
