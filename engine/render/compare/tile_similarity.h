#pragma once

#include <vector>

#include "engine/render/compare/image_mask.h"
#include "engine/render/image/image.h"
#include "engine/script/image_tolerance.h"

namespace campuswalk::engine::render {

/// A tile of two images and how alike they are in it.
struct TileSimilarity {
    PixelBox box;
    double ssim = 1.0;  ///< -1 to 1, 1 for the same
};

/// The structural similarity of two images of one size, tile by tile, row by row (Wang, Bovik, Sheikh and
/// Simoncelli, Image quality assessment: from error visibility to structural similarity, 2004; on brightness,
/// with the paper's constants). Windows of 8 x 8 pixels begin every 4 pixels; a tile's value is the mean of
/// the 16 x 16 windows that begin in it, 64 x 64 pixels. The last tile of a row or column is moved back so
/// that it is a whole one, or is as small as the image. Pixels that are masked are left out of windows, and
/// make a window count for less: a tile that is all masked is 1. Symmetric.
std::vector<TileSimilarity> tile_similarities(const Image& a, const Image& b, const ImageMask& mask);

}  // namespace campuswalk::engine::render
