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

/// What the output folder knows of the run before: its results in the order in which they came.
struct LastRun {
    std::string plan;  ///< fingerprint of what was run
    std::vector<engine::WalkResult> results;
    std::uintmax_t whole_bytes = 0;  ///< without a last line that was cut short when the run was killed
};

/// `OUTPUT/last-run.jsonl`.
std::filesystem::path last_run_file(const std::filesystem::path& output);

/// Nullopt when there is no such file. Throws scene::InputError (bad-last-run) for one that isn't ours.
std::optional<LastRun> read_last_run(const std::filesystem::path& file);

/// The cases that didn't end as they should.
std::set<std::string> failed_ids(const LastRun& run);

/// Changes when something that the results depend on does: cases, walks, campuses, avatars, models
/// (their sizes and dates).
std::string fingerprint(const Plan& plan);

/// Keeps results as they come, so that they survive whatever becomes of this process. They are on the disk
/// a fifth of a second later at most, or when it is closed. Throws std::runtime_error when it can't.
class LastRunWriter {
public:
    /// Starts a file anew, with the folders it needs.
    LastRunWriter(const std::filesystem::path& file, const std::string& plan);
    /// Goes on with one that has been read.
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
