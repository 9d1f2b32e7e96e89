#pragma once

#include <vector>

#include "engine/render/compare/image_mask.h"
#include "engine/render/image/image.h"
#include "engine/script/image_tolerance.h"

namespace campuswalk::engine::render {

/// The similarity of two images in a tile.
struct TileSimilarity {
    PixelBox box;
    double ssim = 1.0;  ///< -1 to 1; 1 if equal
};

/// Structural similarity (SSIM) of two images of one size by tiles, row-major (Wang, Bovik, Sheikh and
/// Simoncelli, Image quality assessment: from error visibility to structural similarity, 2004; on luma, with
/// the paper's constants). Windows are 8 x 8 pixels with a stride of 4; a tile averages 16 x 16 windows. The
/// last tile of a row or column is moved back to full size, unless the image is smaller. Masked pixels are
/// excluded and lower the weight of their windows: a fully masked tile is 1. Symmetric.
std::vector<TileSimilarity> tile_similarities(const Image& a, const Image& b, const ImageMask& mask);

}  // namespace campuswalk::engine::render
