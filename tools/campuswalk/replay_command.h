#pragma once

#include <filesystem>
#include <vector>

namespace campuswalk::tools {

struct ReplayOptions {
    std::filesystem::path run;                 ///< a log or a report as JSON lines
    std::vector<std::filesystem::path> walks;  ///< the walk files of a log
    bool verify = false;                       ///< compare hashes; otherwise the event log is printed
};

/// Simulates the walks of a log or a report again. Returns the exit code.
int replay_run(const ReplayOptions& options);

}  // namespace campuswalk::tools
