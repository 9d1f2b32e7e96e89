#pragma once

#include <filesystem>
#include <optional>

namespace campuswalk::tools {

struct DiffOptions {
    std::filesystem::path a;
    std::filesystem::path b;
    std::optional<std::filesystem::path> pictures;  ///< folder for a.png and b.png
    std::optional<std::filesystem::path> walk;      ///< of the logs; for its campus
};

/// Prints the first divergence of two logs, both sides with some lines around it. Returns the exit code.
int compare_logs(const DiffOptions& options);

}  // namespace campuswalk::tools
