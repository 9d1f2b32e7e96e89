#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "engine/render/geometry/camera.h"
#include "engine/render/overlay/canvas.h"

namespace campuswalk::engine::render {

/// Where the pixels of a plan are in the world. North (-Z) is up.
struct PlanFrame {
    Eigen::Vector2d north_west =
        Eigen::Vector2d::Zero();  ///< x and z at the image's upper left north_west, metres
    double pixels_per_metre = 1.0;

    Eigen::Vector2d pixel_of(const Eigen::Vector2d& xz) const { return pixels_per_metre * (xz - north_west); }
};

/// `view` looks straight down: it is one of top() or plan().
PlanFrame frame_of(const Viewpoint& view, int width, int height);

/// Lines at round coordinates across a plan.
struct MapGrid {
    struct Line {
        double pixel = 0.0;  ///< from the image's left or upper edge
        std::string label;   ///< the coordinate as in YAML; the first line's with the axis: "x = -40"
    };
    double spacing = 0.0;  ///< metres
    std::vector<Line> x;   ///< vertical lines, from left to right
    std::vector<Line> z;   ///< horizontal lines, downwards
};

/// The lines across `area` (pixels), about `distance` pixels from each other: 0.64 to 1.6 times that.
MapGrid grid_across(const PlanFrame& frame, const Eigen::AlignedBox2d& area, double distance);

/// Draws thin lines over the image, their coordinates along the left and lower edges, and instead of a scale
/// bar one cell's length. `view` is as in frame_of().
void draw_map_grid(const Canvas& canvas, const Viewpoint& view);

}  // namespace campuswalk::engine::render
