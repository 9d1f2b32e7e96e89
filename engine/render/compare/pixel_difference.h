#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/render/compare/image_mask.h"
#include "engine/render/image/image.h"

namespace campuswalk::engine::render {

enum class PixelVerdict : std::uint8_t {
    same,         ///< the same bytes
    close,        ///< other bytes, but nearer than the threshold
    antialiased,  ///< farther, but on an edge that was smoothed otherwise
    different,
    masked,
};

struct PixelDifference {
    std::size_t different = 0;           ///< pixels
    std::vector<PixelVerdict> verdicts;  ///< one a pixel, row by row
};

/// How far two colours are apart in the sense of the eye, 0 to 1 (black and white are 0.97 apart): the root
/// of the weighted sum of squares in the space YIQ of NTSC television (Kotsarenko and Ramos, Measuring
/// perceived color difference using YIQ NTSC transmission color space in mobile applications, 2010), as
/// pixelmatch takes it.
double color_distance(const std::uint8_t* rgb_a, const std::uint8_t* rgb_b);

/// Whether a pixel is one that smoothing put between two even areas of different brightness: its darkest and
/// its brightest neighbour aren't equal to it, it has two equals at most, and one of those two neighbours
/// lies in an even area in both images (Vyšniauskas, Anti-aliased pixel and intensity slope detector,
/// 2009).
bool is_antialiased(const Image& image, const Image& other, int x, int y);

/// Which pixels of two images of one size differ by more than `threshold`. Symmetric.
PixelDifference pixel_difference(const Image& a, const Image& b, double threshold, const ImageMask& mask);

}  // namespace campuswalk::engine::render
