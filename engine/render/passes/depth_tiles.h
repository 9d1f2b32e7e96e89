#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace campuswalk::engine::render {

/// The farthest depth in each tile of a partly drawn image. Whatever lies behind it in every tile it covers
/// is occluded. Depth is reversed: 1 near, 0 at infinity (see clip_from_world).
struct DepthTiles {
    static constexpr int kTileWidth = 8;   ///< pixels
    static constexpr int kTileHeight = 4;  ///< lower, as most objects at eye level are wide and low

    int columns = 0;
    int rows = 0;
    std::vector<float> farthest;  ///< row-major, bottom row first

    bool empty() const { return farthest.empty(); }

    /// True only if drawing anything inside the box can't change a pixel of the `width` x `height` image.
    /// `clip_campus` must be a perspective projection.
    bool occlude(const Eigen::AlignedBox3d& box, const Eigen::Matrix4d& clip_campus, int width,
                 int height) const;
};

}  // namespace campuswalk::engine::render
