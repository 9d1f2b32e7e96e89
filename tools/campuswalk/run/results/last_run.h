#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/report/walk_result.h"
#include "tools/campuswalk/run/plan/plan.h"

namespace campuswalk::tools {

/// What the output folder records of the previous run: its results in the order in which they came.
struct LastRun {
    std::string plan;  ///< fingerprint of what was run
    std::vector<engine::WalkResult> results;
    std::uintmax_t whole_bytes = 0;  ///< up to a last line that was cut short when the run was killed
};

/// `OUTPUT/last-run.jsonl`.
std::filesystem::path last_run_file(const std::filesystem::path& output);

/// Nullopt if there is no such file. Throws scene::InputError (bad-last-run) for a file that isn't valid.
std::optional<LastRun> read_last_run(const std::filesystem::path& file);

/// The ids of cases that neither passed nor were skipped.
std::set<std::string> failed_ids(const LastRun& run);

/// Identifies everything that the results depend on: cases, walks, campuses, avatars, models (by size and
/// date).
std::string fingerprint(const Plan& plan);

/// Saves results as they come, so that they survive the end of this process, whatever causes it. They are on
/// the disk after at most a fifth of a second, or once it is closed. Throws std::runtime_error when that
/// fails.
class LastRunWriter {
public:
    /// Creates or replaces the file, with the folders that it needs.
    LastRunWriter(const std::filesystem::path& file, const std::string& plan);
    /// Continues a file that has been read.
    LastRunWriter(const std::filesystem::path& file, const LastRun& run);

    void add(const std::string& result_line);
    void sync_if_due();
    void close();

private:
    void write_line(const std::string& line);
    void sync();

    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::filesystem::path name_;
    std::unique_ptr<std::FILE, Close> file_;
    bool unsynced_ = false;
    double synced_at_ = 0.0;  ///< seconds of a steady clock
};

}  // namespace campuswalk::tools
