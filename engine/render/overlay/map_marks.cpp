#include "engine/render/overlay/map_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <cairo.h>

#include "engine/render/overlay/free_box.h"

namespace campuswalk::engine::render {
namespace {

constexpr Rgba kForeground = {1.0, 1.0, 1.0, 0.95};
constexpr Rgba kOutline = {0.05, 0.07, 0.09, 0.70};
constexpr Rgba kPathColor = {1.0, 0.80, 0.16, 0.95};
constexpr Rgba kArrow = {0.93, 0.23, 0.16, 1.0};
constexpr double kEdge = 26.0;  // pixels from the image border, in an image 720 high

void stroke_outlined(const Canvas& canvas, const Rgba& color, double width, double outline) {
    cairo_t* cr = canvas.cairo();
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
    canvas.set_color(kOutline);
    cairo_set_line_width(cr, width + outline);
    cairo_stroke_preserve(cr);
    canvas.set_color(color);
    cairo_set_line_width(cr, width);
    cairo_stroke(cr);
}

// Where a label may be in units of half its size: at its point, below or above it, beside it.
const std::array<Eigen::Vector2d, 9> kLabelShifts = {
    {{0, 0}, {0, 2}, {0, -2}, {1, 0}, {-1, 0}, {1, 2}, {-1, 2}, {1, -2}, {-1, -2}}};

}  // namespace

double round_length(double metres) {
    const double power = std::pow(10.0, std::floor(std::log10(metres)));
    for (const double step : {5.0, 2.0}) {
        if (step * power <= metres) {
            return step * power;
        }
    }
    return power;
}

std::string length_text(double metres) {
    std::array<char, 40> text{};
    if (metres >= 1000.0) {
        std::snprintf(text.data(), text.size(), "%g km", metres / 1000.0);
    } else {
        std::snprintf(text.data(), text.size(), "%g m", metres);
    }
    return text.data();
}

void draw_scale_bar(const Canvas& canvas, const Viewpoint& view) {
    const double metres_per_pixel = view.height / canvas.height();
    const double length = round_length(0.18 * canvas.width() * metres_per_pixel);
    draw_scale_bar(canvas, length / metres_per_pixel, length_text(length));
}

void draw_scale_bar(const Canvas& canvas, double pixels, const std::string& text) {
    const double s = canvas.scale();
    const double x = canvas.width() - kEdge * s - pixels;
    const double y = canvas.height() - kEdge * s;
    cairo_t* cr = canvas.cairo();
    cairo_move_to(cr, x, y - 7.0 * s);
    cairo_line_to(cr, x, y);
    cairo_line_to(cr, x + pixels, y);
    cairo_line_to(cr, x + pixels, y - 7.0 * s);
    stroke_outlined(canvas, kForeground, 2.2 * s, 3.0 * s);
    canvas.label(x + 0.5 * pixels, y - 16.0 * s, text, {14.0 * s, true, kForeground, 0.0, 1});
}

void draw_north_arrow(const Canvas& canvas) {
    const double s = canvas.scale();
    const double x = canvas.width() - (kEdge + 12.0) * s;
    const double y = (kEdge + 22.0) * s;  // above the first information window
    cairo_t* cr = canvas.cairo();
    cairo_move_to(cr, x, y - 20.0 * s);
    cairo_line_to(cr, x + 9.0 * s, y + 10.0 * s);
    cairo_line_to(cr, x, y + 4.0 * s);
    cairo_line_to(cr, x - 9.0 * s, y + 10.0 * s);
    cairo_close_path(cr);
    canvas.set_color(kForeground);
    cairo_fill_preserve(cr);
    canvas.set_color(kOutline);
    cairo_set_line_width(cr, 1.6 * s);
    cairo_stroke(cr);
    canvas.label(x, y - 32.0 * s, "N", {16.0 * s, true, kForeground, 0.0, 1});
}

void draw_map_labels(const Canvas& canvas, const Viewpoint& view, std::span<const MapLabel> labels) {
    std::vector<PixelLabel> seen;
    for (const MapLabel& label : labels) {
        if (const auto pixel = pixel_of(view, canvas.width(), canvas.height(), label.position)) {
            seen.push_back({label.text, *pixel});
        }
    }
    draw_labels(canvas, seen);
}

void draw_labels(const Canvas& canvas, std::span<const PixelLabel> labels,
                 std::span<const PixelRect> windows) {
    const double s = canvas.scale();
    const TextStyle style = {14.0 * s, true, kForeground, 0.0, 1};
    const Eigen::AlignedBox2d image(Eigen::Vector2d::Zero(),
                                    Eigen::Vector2d(canvas.width(), canvas.height()));
    std::vector<Eigen::AlignedBox2d> taken;
    for (const PixelRect& window : windows) {
        const Eigen::Vector2d upper_left(window.x, window.y);
        taken.emplace_back(upper_left, upper_left + Eigen::Vector2d(window.width, window.height));
    }
    for (const PixelLabel& label : labels) {
        const Eigen::Vector2d half = 0.5 * canvas.text_size(label.text, style) + Eigen::Vector2d(4, 2) * s;
        if (const auto box = free_box(image, label.pixel, half, kLabelShifts, taken)) {
            taken.push_back(*box);
            canvas.label(box->center().x(), box->center().y(), label.text, style);
        }
    }
}

void draw_compass(const Canvas& canvas, double yaw, std::span<const PixelRect> windows) {
    const double s = canvas.scale();
    const double radius = 30.0 * s;
    double right = canvas.width();
    for (const PixelRect& window : windows) {
        right = std::min(right, window.x);
    }
    if (right < 0.5 * canvas.width()) {
        return;  // no room beside the windows
    }
    const double x = right - kEdge * s - radius;
    const double y = kEdge * s + radius;
    cairo_t* cr = canvas.cairo();
    constexpr double kFullTurn = 2.0 * std::numbers::pi;
    canvas.set_color({0.05, 0.07, 0.09, 0.45});
    cairo_arc(cr, x, y, radius, 0.0, kFullTurn);
    cairo_fill_preserve(cr);
    canvas.set_color(kForeground);
    cairo_set_line_width(cr, 2.0 * s);
    cairo_stroke(cr);
    cairo_save(cr);
    cairo_translate(cr, x, y);
    cairo_rotate(cr, yaw);  // after a left turn north is on the right
    for (const bool north : {true, false}) {
        const double tip = (north ? -0.82 : 0.82) * radius;
        cairo_move_to(cr, 0.0, tip);
        cairo_line_to(cr, 0.2 * radius, 0.0);
        cairo_line_to(cr, -0.2 * radius, 0.0);
        cairo_close_path(cr);
        canvas.set_color(north ? kArrow : kForeground);
        cairo_fill(cr);
    }
    cairo_restore(cr);
    const double letter = radius + 11.0 * s;
    canvas.label(x + letter * std::sin(yaw), y - letter * std::cos(yaw), "N",
                 {13.0 * s, true, kForeground, 0.0, 1});
}

void draw_path(const Canvas& canvas, const Viewpoint& view, std::span<const Eigen::Vector3d> path) {
    if (path.size() < 2) {
        return;
    }
    for (const Eigen::Vector3d& point : path) {
        if (const auto pixel = pixel_of(view, canvas.width(), canvas.height(), point)) {
            cairo_line_to(canvas.cairo(), pixel->x(), pixel->y());
        }
    }
    stroke_outlined(canvas, kPathColor, 2.6 * canvas.scale(), 2.2 * canvas.scale());
}

void draw_outline(const Canvas& canvas, const Viewpoint& view, std::span<const Eigen::Vector3d> vertices) {
    for (const Eigen::Vector3d& vertex : vertices) {
        if (const auto pixel = pixel_of(view, canvas.width(), canvas.height(), vertex)) {
            cairo_line_to(canvas.cairo(), pixel->x(), pixel->y());
        }
    }
    cairo_close_path(canvas.cairo());
    stroke_outlined(canvas, kForeground, 1.6 * canvas.scale(), 2.2 * canvas.scale());
}

void draw_dot(const Canvas& canvas, const Eigen::Vector2d& at, double width) {
    cairo_t* cr = canvas.cairo();
    cairo_arc(cr, at.x(), at.y(), 0.5 * width, 0.0, 2.0 * std::numbers::pi);
    canvas.set_color(kPathColor);
    cairo_fill_preserve(cr);
    canvas.set_color(kOutline);
    cairo_set_line_width(cr, 0.2 * width);
    cairo_stroke(cr);
}

void draw_ring(const Canvas& canvas, double x, double y) {
    const double s = canvas.scale();
    cairo_arc(canvas.cairo(), x, y, 15.0 * s, 0.0, 2.0 * std::numbers::pi);
    stroke_outlined(canvas, kArrow, 2.6 * s, 2.2 * s);
}

void draw_heading_arrow(const Canvas& canvas, const Eigen::Vector2d& at, double yaw, double size) {
    cairo_t* cr = canvas.cairo();
    cairo_save(cr);
    cairo_translate(cr, at.x(), at.y());
    cairo_rotate(cr, -yaw);  // y points down
    cairo_move_to(cr, 0.0, -size);
    cairo_line_to(cr, 0.68 * size, 0.85 * size);
    cairo_line_to(cr, 0.0, 0.45 * size);
    cairo_line_to(cr, -0.68 * size, 0.85 * size);
    cairo_close_path(cr);
    cairo_restore(cr);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    canvas.set_color({1, 1, 1, 0.95});
    cairo_set_line_width(cr, 0.28 * size);
    cairo_stroke_preserve(cr);
    canvas.set_color(kArrow);
    cairo_fill(cr);
}

}  // namespace campuswalk::engine::render
