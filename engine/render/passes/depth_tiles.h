#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace campuswalk::engine::render {

/// The farthest depth in each tile of an image that is being drawn: what is farther than that in every tile
/// it would touch can't be seen any more. Depths are reversed: 1 near, 0 at infinity, as clip_from_world has
/// them.
struct DepthTiles {
    static constexpr int kTileWidth = 8;   ///< pixels
    static constexpr int kTileHeight = 4;  ///< less: from a person's eyes most things are wide and low

    int columns = 0;
    int rows = 0;
    std::vector<float> farthest;  ///< row by row from the lower edge on

    bool empty() const { return farthest.empty(); }

    /// True only when no pixel of the `width` x `height` image that `clip_campus` (a perspective) makes
    /// would change if something within the box were drawn.
    bool hide(const Eigen::AlignedBox3d& box, const Eigen::Matrix4d& clip_campus, int width,
              int height) const;
};

}  // namespace campuswalk::engine::render
