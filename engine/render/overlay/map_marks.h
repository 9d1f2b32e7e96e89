#pragma once

#include <span>
#include <string>

#include <Eigen/Core>

#include "engine/render/geometry/camera.h"
#include "engine/render/overlay/canvas.h"
#include "engine/render/overlay/info_window.h"

namespace campuswalk::engine::render {

/// A label at a point in the world frame.
struct MapLabel {
    std::string text;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// A label at a point in the image.
struct PixelLabel {
    std::string text;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

/// The longest "round" length (1, 2 or 5 times a power of ten, metres) not above `metres`.
double round_length(double metres);
/// "20 m" or "5 km".
std::string length_text(double metres);

/// `view` is the orthographic view that the image was drawn with.
void draw_scale_bar(const Canvas& canvas, const Viewpoint& view);
/// Likewise in the lower right corner, of a given length.
void draw_scale_bar(const Canvas& canvas, double pixels, const std::string& text);
void draw_north_arrow(const Canvas& canvas);
/// Labels, moved slightly where they would overlap.
void draw_map_labels(const Canvas& canvas, const Viewpoint& view, std::span<const MapLabel> labels);
/// Likewise, avoiding the windows.
void draw_labels(const Canvas& canvas, std::span<const PixelLabel> labels,
                 std::span<const PixelRect> windows = {});
/// A compass for a camera with heading `yaw` (up is ahead), in the upper right corner or left of the windows
/// there.
void draw_compass(const Canvas& canvas, double yaw, std::span<const PixelRect> windows = {});
/// `path` is in the world frame.
void draw_path(const Canvas& canvas, const Viewpoint& view, std::span<const Eigen::Vector3d> path);
/// The outline of an area; `vertices` are in the world frame.
void draw_outline(const Canvas& canvas, const Viewpoint& view, std::span<const Eigen::Vector3d> vertices);
/// A dot at a point of the image, as wide as so many pixels.
void draw_dot(const Canvas& canvas, const Eigen::Vector2d& at, double width);
/// A ring around a point of the image.
void draw_ring(const Canvas& canvas, double x, double y);
/// An arrow of `size` pixels along the heading `yaw` on a north-up map.
void draw_heading_arrow(const Canvas& canvas, const Eigen::Vector2d& at, double yaw, double size);

}  // namespace campuswalk::engine::render
