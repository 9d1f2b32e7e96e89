#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <ios>
#include <optional>
#include <string>
#include <vector>

#include "engine/report/run_plan.h"
#include "engine/report/walk_result.h"

namespace campuswalk::tools {

using ResultVisitor = std::function<void(engine::WalkResult&& result)>;

/// What `--reporter jsonl=FILE` wrote, read a line at a time: its results need no memory. Their paths are
/// again as seen from the folder where the run was started.
class ResultFile {
public:
    /// nullopt if the file isn't such a report. Throws scene::InputError: missing-file; bad-report for a
    /// header of another version.
    static std::optional<ResultFile> open(const std::filesystem::path& file);

    const std::filesystem::path& file() const { return file_; }
    const engine::RunPlan& plan() const { return plan_; }

    /// Calls `visit` for each result, in the file's order, and returns how many there are. A last line that
    /// was cut short doesn't count. Throws scene::InputError (bad-report) at a line that isn't a result.
    std::size_t for_each(const ResultVisitor& visit) const;
    /// The same, with where each result is in the file, bytes.
    std::size_t for_each_located(
        const std::function<void(std::streamoff offset, engine::WalkResult&& result)>& visit) const;
    /// The result at such an offset.
    engine::WalkResult read_at(std::streamoff offset) const;

private:
    std::filesystem::path file_;
    engine::RunPlan plan_;
};

/// The reports among the inputs and, of folders, in them and below; at least one of each input. Throws
/// scene::InputError: missing-file, bad-report.
std::vector<ResultFile> open_result_files(const std::vector<std::filesystem::path>& inputs);

/// The names of such inputs without their folders: the same on every machine.
std::string title_of_inputs(const std::vector<std::filesystem::path>& inputs);

}  // namespace campuswalk::tools
