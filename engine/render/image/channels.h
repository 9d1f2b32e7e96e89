#pragma once

#include <cstdint>
#include <vector>

#include "engine/render/image/image.h"

namespace campuswalk::engine::render {

/// What is wanted of a view besides its colours.
struct ChannelChoice {
    bool nodes = false;
    bool depth = false;
    bool normals = false;
};

/// What the pixels of a view show, in numbers: each is what a ray through its middle meets first, nothing is
/// averaged over a pixel's edges. Holes of cut-outs are holes, and a see-through surface counts where it
/// hides at least half of what is behind it: foliage does, window panes and water don't. Rows from top to
/// bottom; a channel that wasn't asked for is empty.
struct Channels {
    int width = 0;   ///< pixels
    int height = 0;  ///< pixels
    /// The node's number: those of all models one after the other, from 1 on. 0 is nothing, or the avatar.
    std::vector<std::uint32_t> nodes;
    /// Metres before the camera, measured along its axis as depth cameras do; 0 is nothing.
    std::vector<float> depth;
    /// The shading normal's side that faces the camera, world frame: 128 + 127 times x, y, z as red, green,
    /// blue; black is nothing.
    Image normals;
};

}  // namespace campuswalk::engine::render
