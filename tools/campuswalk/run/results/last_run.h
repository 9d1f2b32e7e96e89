#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/report/walk_result.h"
#include "scene/base/new_file.h"

namespace campuswalk::tools {

/// What the output folder records of the previous run: its results in the order in which they came.
struct LastRun {
    std::string plan;  ///< resume_fingerprint() of what was run
    std::vector<engine::WalkResult> results;
    std::uintmax_t whole_bytes = 0;  ///< up to a last line that was cut short when the run was killed
    bool authentic = false;          ///< all lines were written with the same key
};

/// Nullopt if there is no such file. Throws scene::InputError (bad-last-run) for a file that isn't valid.
/// `key`: see run_key.h; with none nothing is authentic.
std::optional<LastRun> read_last_run(const std::filesystem::path& file, const std::string& key);

/// The ids of cases that neither passed nor were skipped.
std::set<std::string> failed_ids(const LastRun& run);

/// Saves results as they come, so that they survive the end of this process, whatever causes it. They are on
/// the disk after at most a fifth of a second, or once it is closed. Throws std::runtime_error when that
/// fails.
class LastRunWriter {
public:
    /// Creates or replaces the file, with the folders that it needs.
    LastRunWriter(const std::filesystem::path& file, const std::string& plan, std::string key);
    /// Continues a file that has been read.
    LastRunWriter(const std::filesystem::path& file, const LastRun& run, std::string key);

    /// `microseconds` is how long the case took, if it was played.
    void add(const std::string& result_line, std::optional<std::uint64_t> microseconds = {});
    void sync_if_due();
    void close();

private:
    void write_line(const std::string& object);
    void sync();

    std::filesystem::path name_;
    std::string plan_;
    std::string key_;
    scene::FileStream file_;
    bool unsynced_ = false;
    double synced_at_ = 0.0;  ///< seconds of a steady clock
};

}  // namespace campuswalk::tools
