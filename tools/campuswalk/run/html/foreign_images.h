#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "engine/html_report/html_reporter.h"
#include "scene/import/helper/image_process.h"

namespace campuswalk::tools {

/// What a report takes of pictures, which may come from anywhere.
struct ImageBudget {
    std::uint64_t pixels_of_one = std::uint64_t{1} << 26U;  ///< 8192 x 8192, the largest that a walk can take
    std::uint64_t pixels_of_all = 10'000'000'000;           ///< 10,000 pictures of 1280 x 720
    std::uint64_t pixels_at_once = std::uint64_t{1} << 26U;  ///< are decoded by one process
};

/// Decodes some PNG files elsewhere.
using ImageDecoder = std::function<std::vector<scene::ForeignImage>(const std::vector<std::string_view>&)>;

/// Reads a report's pictures within a budget. Those that are no PNG files, too large, damaged or beyond the
/// budget are left out, each with a warning (bad-picture).
engine::ImageReader image_reader(ImageDecoder decode, const ImageBudget& budget = {});

}  // namespace campuswalk::tools
