#include "engine/render/passes/depth_tiles.h"

#include <algorithm>
#include <cmath>

namespace campuswalk::engine::render {
namespace {

// The driver places vertices by floats and snaps them to a 256th of a pixel: boxes are taken a little nearer
// and wider than they are.
constexpr double kNearer = 0.02;  // metres
constexpr double kWider = 1.0;    // pixels

// Nearer than this nothing is asked: it is drawn.
constexpr double kLeastDistance = 1.0;

/// Where a box is in an image: pixels, and the depth of its nearest corner.
struct Footprint {
    Eigen::AlignedBox2d pixels;
    double nearest = 0.0;
    bool known = true;  ///< false: part of it is beside or behind the camera
};

Footprint footprint(const Eigen::AlignedBox3d& box, const Eigen::Matrix4d& clip_campus, int width,
                    int height) {
    Footprint print;
    for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
        const Eigen::Vector4d clip = clip_campus * corner.homogeneous();
        const double distance = clip.w() - kNearer;
        if (distance < kLeastDistance) {
            print.known = false;
            return print;
        }
        print.pixels.extend(Eigen::Vector2d(0.5 * width * (clip.x() / clip.w() + 1.0),
                                            0.5 * height * (clip.y() / clip.w() + 1.0)));
        print.nearest = std::max(print.nearest, clip.z() / distance);
    }
    return print;
}

}  // namespace

bool DepthTiles::hide(const Eigen::AlignedBox3d& box, const Eigen::Matrix4d& clip_campus, int width,
                      int height) const {
    const Footprint print = footprint(box, clip_campus, width, height);
    if (!print.known) {
        return false;
    }
    const auto tile = [](double pixel, int size, int count) {
        return static_cast<int>(std::clamp(std::floor(pixel / size), 0.0, count - 1.0));
    };
    const int left = tile(print.pixels.min().x() - kWider, kTileWidth, columns);
    const int right = tile(print.pixels.max().x() + kWider, kTileWidth, columns);
    const int bottom = tile(print.pixels.min().y() - kWider, kTileHeight, rows);
    const int top = tile(print.pixels.max().y() + kWider, kTileHeight, rows);
    for (int row = bottom; row <= top; ++row) {
        for (int column = left; column <= right; ++column) {
            const float depth = farthest[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                                         static_cast<std::size_t>(column)];
            if (print.nearest >= static_cast<double>(depth)) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace campuswalk::engine::render
