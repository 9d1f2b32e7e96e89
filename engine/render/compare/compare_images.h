#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/render/compare/pixel_difference.h"
#include "engine/render/compare/tile_similarity.h"
#include "engine/render/image/image.h"
#include "engine/script/image_tolerance.h"

namespace campuswalk::engine::render {

/// How two pictures of one size differ, by both rules.
struct PictureComparison {
    PixelDifference pixels;
    double ratio = 0.0;                 ///< of the pixels that differ, of all
    std::vector<TileSimilarity> tiles;  ///< row by row
    TileSimilarity worst;               ///< the first of those least alike
};

/// Both pictures must have one size, one pixel at least. Symmetric.
PictureComparison compare_pictures(const Picture& a, const Picture& b, const PictureTolerance& tolerance);

/// Which rules of the tolerance don't hold, in words; empty when they all do.
std::string why_different(const PictureComparison& comparison, const PictureTolerance& tolerance);

/// A picture for the eye. Grey and pale: the same. Orange: other colours, within the threshold. Yellow:
/// smoothed otherwise. Red: different. Hatched: masked. Tiles that aren't alike enough have a magenta frame.
Picture draw_difference(const Picture& a, const Picture& b, const PictureComparison& comparison,
                        const PictureTolerance& tolerance);

}  // namespace campuswalk::engine::render
