#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/report/run_plan.h"
#include "engine/report/walk_result.h"
#include "tools/campuswalk/base/file_lines.h"

namespace campuswalk::tools {

using ResultVisitor = std::function<void(engine::WalkResult&& result)>;

/// The line as a report has it, signed with a key that machines share; without a key as it is. `header` is
/// the report's header, empty for the header itself: lines of one report can't be moved into another.
std::string report_line(const std::string& object, const std::string& header,
                        const std::optional<std::string>& key);

/// What `--reporter jsonl=FILE` wrote, read a line at a time: its results need no memory. Their paths are
/// again as seen from the folder where the run was started.
class ResultFile {
public:
    /// nullopt if the file isn't such a report. With a key, every line must have been signed with it. Throws
    /// scene::InputError: missing-file, long-line; bad-report for a header of another version;
    /// foreign-results for a header that wasn't signed with the key.
    static std::optional<ResultFile> open(const std::filesystem::path& file,
                                          const std::optional<std::string>& key = {});

    const std::filesystem::path& file() const { return file_; }
    const engine::RunPlan& plan() const { return plan_; }

    /// Calls `visit` for each result, in the file's order, and returns how many there are. A last line that
    /// was cut short doesn't count. Throws scene::InputError at a line that isn't a result (bad-report), is
    /// too long (long-line) or wasn't signed with the key (foreign-results).
    std::size_t for_each(const ResultVisitor& visit) const;
    /// The same, with where each result is in the file, bytes.
    std::size_t for_each_located(
        const std::function<void(std::uintmax_t offset, engine::WalkResult&& result)>& visit) const;
    /// The result at such an offset.
    engine::WalkResult read_at(std::uintmax_t offset) const;

private:
    friend class ResultBlocks;

    engine::WalkResult result_of(std::string_view line, int number) const;

    std::filesystem::path file_;
    engine::RunPlan plan_;
    std::string header_;  ///< the first line, without its signature
    std::optional<std::string> key_;
};

/// The results of a file one after the other, of which only a block is in memory. The file is open only while
/// a block is read.
class ResultBlocks {
public:
    /// `file` must live as long as this.
    ResultBlocks(const ResultFile& file, std::size_t block_bytes);

    /// nullopt at the end; a last line that was cut short doesn't count. Throws as ResultFile::for_each.
    std::optional<engine::WalkResult> next();

private:
    const ResultFile* file_;
    FileLines lines_;
};

/// The reports among the inputs and, of folders, in them and below; at least one of each input. Throws
/// scene::InputError as ResultFile::open.
std::vector<ResultFile> open_result_files(const std::vector<std::filesystem::path>& inputs,
                                          const std::optional<std::string>& key = {});

/// The lines of such a report without their signatures. With a key, each must have been signed with it
/// (foreign-results).
std::vector<std::string> unsigned_lines(const std::filesystem::path& file,
                                        const std::vector<std::string>& lines,
                                        const std::optional<std::string>& key);

/// The names of such inputs without their folders: the same on every machine.
std::string title_of_inputs(const std::vector<std::filesystem::path>& inputs);

}  // namespace campuswalk::tools
