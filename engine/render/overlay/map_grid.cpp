#include "engine/render/overlay/map_grid.h"

#include <algorithm>
#include <cmath>

#include <cairo.h>

#include "engine/events/decimals.h"
#include "engine/render/overlay/map_marks.h"

namespace campuswalk::engine::render {
namespace {

// Pixels in an image 720 high.
constexpr double kDistance = 100.0;
constexpr double kText = 12.0;
constexpr double kFromEdge = 5.0;  // of the labels
constexpr double kCaption = 44.0;  // high: no label of a line there
constexpr double kBottom = 30.0;   // where the labels of x are

// Round spacings are up to 2.5 times each other: as far below the wanted distance as above it.
constexpr double kLongest = 1.6;

constexpr Rgba kShade = {0.05, 0.07, 0.09, 0.16};  // shows the line on bright ground
constexpr Rgba kLight = {1.0, 1.0, 1.0, 0.34};     // and on dark ground
constexpr Rgba kTextColor = {1.0, 1.0, 1.0, 0.92};

/// Across dimension 0 or 1 of the plan, which is called `axis`.
std::vector<MapGrid::Line> lines_along(const char* axis, int dimension, const PlanFrame& frame,
                                       const Eigen::AlignedBox2d& area, double spacing) {
    const double pixels_per_metre = frame.pixels_per_metre;
    const double north_west = frame.north_west[dimension];
    const double from = area.min()[dimension];
    const double to = area.max()[dimension];
    const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(spacing) - 1e-9)));
    constexpr double kSlack = 1e-6;  // of the spacing: a line on the very edge is one
    const double first = std::ceil((north_west + from / pixels_per_metre) / spacing - kSlack);
    const double last = std::floor((north_west + to / pixels_per_metre) / spacing + kSlack);
    // Coordinates may be so large that the next line has the same.
    const double spacings = (to - from) / pixels_per_metre / spacing + 2.0 * kSlack;
    std::vector<MapGrid::Line> lines;
    for (int i = 0; first + i <= last && i <= spacings; ++i) {
        const double at = (first + i) * spacing;
        const std::string label = fixed(at, digits);
        lines.push_back(
            {pixels_per_metre * (at - north_west), i == 0 ? std::string(axis) + " = " + label : label});
    }
    return lines;
}

/// Adds whole pixels' middles, so that a line isn't spread over two.
void add_lines(const Canvas& canvas, const MapGrid& grid) {
    cairo_t* cr = canvas.cairo();
    for (const MapGrid::Line& line : grid.x) {
        cairo_move_to(cr, std::floor(line.pixel) + 0.5, 0.0);
        cairo_line_to(cr, std::floor(line.pixel) + 0.5, canvas.height());
    }
    for (const MapGrid::Line& line : grid.z) {
        cairo_move_to(cr, 0.0, std::floor(line.pixel) + 0.5);
        cairo_line_to(cr, canvas.width(), std::floor(line.pixel) + 0.5);
    }
}

void draw_coordinates(const Canvas& canvas, const MapGrid& grid) {
    const double s = canvas.scale();
    const TextStyle style = {kText * s, false, kTextColor, 0.0, 1};
    double free_from = kFromEdge * s;
    for (const MapGrid::Line& line : grid.x) {
        const double half = 0.5 * canvas.text_size(line.label, style).x();
        // The first one, which names the axis, is drawn in any case.
        const double middle =
            free_from == kFromEdge * s ? std::max(line.pixel, free_from + half) : line.pixel;
        if (middle - half >= free_from && middle + half <= canvas.width()) {
            canvas.label(middle, canvas.height() - 9.0 * s, line.label, style);
            free_from = middle + half + kFromEdge * s;
        }
    }
    for (const MapGrid::Line& line : grid.z) {
        const double half = 0.5 * canvas.text_size(line.label, style).x();
        canvas.label(kFromEdge * s + half, line.pixel, line.label, style);
    }
}

}  // namespace

PlanFrame frame_of(const Viewpoint& view, int width, int height) {
    PlanFrame frame;
    frame.pixels_per_metre = height / view.height;
    frame.north_west = Eigen::Vector2d(view.position.x(), view.position.z()) -
                       Eigen::Vector2d(0.5 * width, 0.5 * height) / frame.pixels_per_metre;
    return frame;
}

MapGrid grid_across(const PlanFrame& frame, const Eigen::AlignedBox2d& area, double distance) {
    MapGrid grid;
    grid.spacing = round_length(kLongest * distance / frame.pixels_per_metre);
    grid.x = lines_along("x", 0, frame, area, grid.spacing);
    grid.z = lines_along("z", 1, frame, area, grid.spacing);
    return grid;
}

void draw_map_grid(const Canvas& canvas, const Viewpoint& view) {
    const double s = canvas.scale();
    const PlanFrame frame = frame_of(view, canvas.width(), canvas.height());
    // Without the margins, where a line would have no label.
    const Eigen::AlignedBox2d area(Eigen::Vector2d(0.0, kCaption * s),
                                   Eigen::Vector2d(canvas.width(), canvas.height() - kBottom * s));
    const MapGrid grid = grid_across(frame, area, kDistance * s);
    cairo_t* cr = canvas.cairo();
    add_lines(canvas, grid);
    canvas.set_color(kShade);
    cairo_set_line_width(cr, 3.0);
    cairo_stroke_preserve(cr);
    canvas.set_color(kLight);
    cairo_set_line_width(cr, 1.0);
    cairo_stroke(cr);
    draw_coordinates(canvas, grid);
    draw_scale_bar(canvas, grid.spacing * frame.pixels_per_metre, "grid " + length_text(grid.spacing));
}

}  // namespace campuswalk::engine::render
