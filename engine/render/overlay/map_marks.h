#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "engine/render/geometry/camera.h"
#include "engine/render/overlay/canvas.h"
#include "engine/render/overlay/info_window.h"

namespace campuswalk::engine::render {

/// A name to write on a map at a place in the world.
struct MapLabel {
    std::string text;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// A name to write at a place in the image.
struct PixelLabel {
    std::string text;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

/// The longest "round" length (1, 2 or 5 times a power of ten, metres) not above `metres`.
double round_length(double metres);

/// What makes a top view a map; `view` is the orthographic view that the canvas' image was drawn with.
void draw_scale_bar(const Canvas& canvas, const Viewpoint& view);
void draw_north_arrow(const Canvas& canvas);
/// Names at their places, moved a little where they would cover each other.
void draw_map_labels(const Canvas& canvas, const Viewpoint& view, std::span<const MapLabel> labels);
/// Likewise beside the windows, which stand there already.
void draw_labels(const Canvas& canvas, std::span<const PixelLabel> labels,
                 std::span<const WindowRect> windows = {});
/// Where north is for a camera with the heading `yaw`, in the upper right corner, or to the left of the
/// windows there: up is ahead.
void draw_compass(const Canvas& canvas, double yaw, std::span<const WindowRect> windows = {});
/// The way walked so far, world points.
void draw_path(const Canvas& canvas, const Viewpoint& view, std::span<const Eigen::Vector3d> path);
/// An arrow head of `size` pixels at (x, y) that points along the heading `yaw` on a north-up map.
void draw_heading_arrow(const Canvas& canvas, double x, double y, double yaw, double size);

}  // namespace campuswalk::engine::render
