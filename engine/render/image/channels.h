#pragma once

#include <cstdint>
#include <vector>

#include "engine/render/image/image.h"

namespace campuswalk::engine::render {

/// Which channels to draw besides colour.
struct ChannelChoice {
    bool nodes = false;
    bool depth = false;
    bool normals = false;
};

/// Per-pixel data of an image: what a ray through the pixel's centre hits first, without anti-aliasing.
/// Cut-outs have holes, and a blended surface counts where its alpha is at least a half: foliage does, window
/// panes and water don't. Rows from top to bottom; channels that weren't requested are empty.
struct Channels {
    int width = 0;   ///< pixels
    int height = 0;  ///< pixels
    /// Node number: one-based, counted over all models. 0 is the background or the avatar.
    std::vector<std::uint32_t> nodes;
    /// Metres along the camera axis; 0 is the background.
    std::vector<float> depth;
    /// Shading normals towards the camera, world frame: red, green, blue = 128 + 127 (x, y, z); black is the
    /// background.
    Image normals;
};

}  // namespace campuswalk::engine::render
