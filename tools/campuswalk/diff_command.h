#pragma once

#include <filesystem>
#include <optional>

#include "tools/campuswalk/rendering_backend.h"

namespace campuswalk::tools {

struct DiffOptions {
    std::filesystem::path a;
    std::filesystem::path b;
    std::optional<std::filesystem::path> images;  ///< folder for a.png and b.png
    std::optional<std::filesystem::path> walk;    ///< of the logs; for its campus
    Backend backend = Backend::automatic;         ///< draws the images
};

/// Prints the first divergence of two logs, both sides with some lines around it. Returns the exit code.
int compare_logs(const DiffOptions& options);

}  // namespace campuswalk::tools
