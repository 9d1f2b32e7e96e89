#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/render/compare/pixel_difference.h"
#include "engine/render/compare/tile_similarity.h"
#include "engine/render/image/image.h"
#include "engine/script/image_tolerance.h"

namespace campuswalk::engine::render {

/// How two images of one size differ, by both rules.
struct ImageComparison {
    PixelDifference pixels;
    double ratio = 0.0;                 ///< of the pixels that differ, of all
    std::vector<TileSimilarity> tiles;  ///< row by row
    TileSimilarity worst;               ///< the first of those least alike
};

/// Both images must have one size, one pixel at least. Symmetric.
ImageComparison compare_images(const Image& a, const Image& b, const ImageTolerance& tolerance);

/// Which rules of the tolerance don't hold, in words; empty when they all do.
std::string describe_violations(const ImageComparison& comparison, const ImageTolerance& tolerance);

/// An image for the eye. Grey and pale: the same. Orange: other colours, within the threshold. Yellow:
/// smoothed otherwise. Red: different. Hatched: masked. Tiles that aren't alike enough have a magenta frame.
Image draw_difference(const Image& a, const Image& b, const ImageComparison& comparison,
                      const ImageTolerance& tolerance);

}  // namespace campuswalk::engine::render
