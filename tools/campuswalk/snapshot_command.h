#pragma once

#include <filesystem>
#include <string>

namespace campuswalk::tools {

struct SnapshotOptions {
    std::filesystem::path campus;
    std::string camera = "top";  ///< "top" for a plan of everything, or a spawn's name to look from there
    std::filesystem::path output;
    int width = 1280;  ///< pixels
    int height = 720;  ///< pixels
};

/// Draws one picture of a campus nobody walks in. Returns the exit code.
int draw_snapshot(const SnapshotOptions& options);

}  // namespace campuswalk::tools
