#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace campuswalk::tools {

struct ReplayOptions {
    std::filesystem::path run;                 ///< a log or a report as JSON lines
    std::vector<std::filesystem::path> walks;  ///< the walk files of a log
    /// The walks.config.yaml with the walks' projects; otherwise the one that a report names or, for a log,
    /// the one here or above.
    std::optional<std::filesystem::path> config;
    bool verify = false;  ///< compare hashes; otherwise the event log is printed
};

/// Simulates the walks of a log or a report again. Returns the exit code.
int replay_run(const ReplayOptions& options);

}  // namespace campuswalk::tools
