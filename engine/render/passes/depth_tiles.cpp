#include "engine/render/passes/depth_tiles.h"

#include <algorithm>
#include <cmath>

namespace campuswalk::engine::render {
namespace {

// The driver transforms vertices in floats and snaps them to 1/256 pixel, so boxes are tested with a margin
// in depth and on the screen.
constexpr double kDepthMargin = 0.02;  // metres
constexpr double kPixelMargin = 1.0;   // pixels

// Metres. Boxes closer than this are always drawn.
constexpr double kMinDistance = 1.0;

/// Screen-space bounds of a box, and the depth of its nearest vertex.
struct Footprint {
    Eigen::AlignedBox2d pixels;
    double nearest = 0.0;
    bool known = true;  ///< false: part of the box is too close to or behind the camera
};

Footprint footprint_of(const Eigen::AlignedBox3d& box, const Eigen::Matrix4d& clip_campus, int width,
                       int height) {
    Footprint footprint;
    for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d vertex = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
        const Eigen::Vector4d clip = clip_campus * vertex.homogeneous();
        const double distance = clip.w() - kDepthMargin;
        if (distance < kMinDistance) {
            footprint.known = false;
            return footprint;
        }
        footprint.pixels.extend(Eigen::Vector2d(0.5 * width * (clip.x() / clip.w() + 1.0),
                                                0.5 * height * (clip.y() / clip.w() + 1.0)));
        footprint.nearest = std::max(footprint.nearest, clip.z() / distance);
    }
    return footprint;
}

}  // namespace

bool DepthTiles::occlude(const Eigen::AlignedBox3d& box, const Eigen::Matrix4d& clip_campus, int width,
                         int height) const {
    const Footprint footprint = footprint_of(box, clip_campus, width, height);
    if (!footprint.known) {
        return false;
    }
    const auto tile = [](double pixel, int size, int count) {
        return static_cast<int>(std::clamp(std::floor(pixel / size), 0.0, count - 1.0));
    };
    const int left = tile(footprint.pixels.min().x() - kPixelMargin, kTileWidth, columns);
    const int right = tile(footprint.pixels.max().x() + kPixelMargin, kTileWidth, columns);
    const int bottom = tile(footprint.pixels.min().y() - kPixelMargin, kTileHeight, rows);
    const int top = tile(footprint.pixels.max().y() + kPixelMargin, kTileHeight, rows);
    for (int row = bottom; row <= top; ++row) {
        for (int column = left; column <= right; ++column) {
            const float depth = farthest[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                                         static_cast<std::size_t>(column)];
            if (footprint.nearest >= static_cast<double>(depth)) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace campuswalk::engine::render
