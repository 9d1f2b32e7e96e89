#pragma once

#include <filesystem>
#include <optional>

#include "engine/script/image_tolerance.h"

namespace campuswalk::tools {

struct ImgdiffOptions {
    std::filesystem::path a;
    std::filesystem::path b;
    engine::ImageTolerance tolerance;
    std::optional<std::filesystem::path> diff;  ///< where to draw the difference
    bool json = false;
};

/// Compares two PNG files and prints how they differ. Returns the exit code: kPass when they are the same
/// within the tolerance, kDifferent otherwise, also when their sizes differ. A build without rendering can't
/// read images and throws.
int compare_image_files(const ImgdiffOptions& options);

}  // namespace campuswalk::tools
