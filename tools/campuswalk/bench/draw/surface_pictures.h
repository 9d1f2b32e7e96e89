#pragma once

#include <vector>

#include "scene/model/model.h"

namespace campuswalk::tools::bench {

/// How many metres a picture covers, each way.
constexpr double kPictureMetres = 3.0;

/// Pictures of what a campus is made of, 512 pixels a side, that repeat without a seam. The same everywhere.
enum class SurfacePicture : std::uint8_t { grass, paving, bricks, leaves, planks };

/// In the order of SurfacePicture.
std::vector<scene::Texture> surface_pictures();

}  // namespace campuswalk::tools::bench
