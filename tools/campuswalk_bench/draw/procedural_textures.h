#pragma once

#include <vector>

#include "scene/model/model.h"

namespace campuswalk::tools::bench {

/// How many metres an image covers, each way.
constexpr double kImageMetres = 3.0;

/// Images of what a campus is made of, 512 pixels a side, that repeat without a seam. The same everywhere.
enum class SurfaceImage : std::uint8_t { grass, paving, bricks, leaves, planks };

/// In the order of SurfaceImage.
std::vector<scene::Texture> surface_images();

}  // namespace campuswalk::tools::bench
