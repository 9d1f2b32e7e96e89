#pragma once

#include <vector>

#include "scene/model/model.h"

namespace campuswalk::tools::bench {

/// The metres that an image covers in each direction.
constexpr double kImageMetres = 3.0;

/// Images of a campus' surfaces, 512 x 512 pixels, that repeat without a seam. The same on every platform.
enum class SurfaceImage : std::uint8_t { grass, paving, bricks, leaves, planks };

/// In the order of SurfaceImage.
std::vector<scene::Texture> surface_images();

}  // namespace campuswalk::tools::bench
