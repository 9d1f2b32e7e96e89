#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace campuswalk::tools {

enum class Backend { automatic, osmesa, none };

struct RunOptions {
    std::vector<std::filesystem::path> walks;
    std::optional<std::filesystem::path> log;    ///< the text log once more, in a file
    std::optional<std::filesystem::path> jsonl;  ///< the events as JSON lines
    std::filesystem::path output = "out";        ///< snapshots go to OUTPUT/WALK NAME/
    Backend backend = Backend::automatic;
    bool quiet = false;  ///< no log on the terminal
};

/// Reads and checks all walks, then runs those that are in order. Returns the exit code.
int run_walks(const RunOptions& options);

}  // namespace campuswalk::tools
