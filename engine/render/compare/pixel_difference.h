#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/render/compare/image_mask.h"
#include "engine/render/image/image.h"

namespace campuswalk::engine::render {

enum class PixelVerdict : std::uint8_t {
    same,         ///< same bytes
    close,        ///< within the threshold
    antialiased,  ///< beyond it, but on an edge that was anti-aliased differently
    different,
    masked,
};

struct PixelDifference {
    std::size_t different = 0;           ///< pixels
    std::vector<PixelVerdict> verdicts;  ///< one per pixel, row-major
};

/// Perceptual colour distance, 0 to 1 (black to white is 0.97): weighted Euclidean distance in YIQ
/// (Kotsarenko and Ramos, Measuring perceived color difference using YIQ NTSC transmission color space in
/// mobile applications, 2010), like pixelmatch.
double color_distance(const std::uint8_t* rgb_a, const std::uint8_t* rgb_b);

/// Compares two images of one size by pixels. Symmetric.
PixelDifference pixel_difference(const Image& a, const Image& b, double threshold, const ImageMask& mask);

}  // namespace campuswalk::engine::render
