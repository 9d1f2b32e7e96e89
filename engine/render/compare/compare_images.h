#pragma once

#include <string>
#include <vector>

#include "engine/render/compare/pixel_difference.h"
#include "engine/render/compare/tile_similarity.h"
#include "engine/render/image/image.h"
#include "engine/script/image_tolerance.h"

namespace campuswalk::engine::render {

/// The differences between two images of one size, by pixels and by tiles.
struct ImageComparison {
    PixelDifference pixels;
    double ratio = 0.0;                 ///< share of pixels that differ
    std::vector<TileSimilarity> tiles;  ///< row by row
    TileSimilarity worst;               ///< the first of the least similar
};

/// The images must have the same size of at least one pixel. Symmetric.
ImageComparison compare_images(const Image& a, const Image& b, const ImageTolerance& tolerance);

/// Describes the violated limits of the tolerance; empty if there are none.
std::string describe_violations(const ImageComparison& comparison, const ImageTolerance& tolerance);

/// Visualizes the differences. Pale grey: equal. Orange: within the threshold. Yellow: anti-aliased
/// differently. Red: different. Hatched: masked. Dissimilar tiles have a magenta border.
Image draw_difference(const Image& a, const Image& b, const ImageComparison& comparison,
                      const ImageTolerance& tolerance);

}  // namespace campuswalk::engine::render
