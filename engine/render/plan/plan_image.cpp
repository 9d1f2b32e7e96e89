#include "engine/render/plan/plan_image.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include <cairo.h>

#include "engine/render/overlay/map_grid.h"
#include "engine/render/overlay/map_marks.h"
#include "engine/render/plan/plan_legend.h"
#include "engine/render/plan/plan_marks.h"
#include "engine/render/plan/plan_style.h"

namespace campuswalk::engine::render {

namespace {

constexpr double kRimShade = 0.52;  // of the colour inside

// What wins a pixel that two kinds share equally: the rarer and more important one.
constexpr std::array kByImportance = {PlanCell::no_return, PlanCell::unreached, PlanCell::solid,
                                      PlanCell::reached, PlanCell::nothing};

struct Span {
    int begin = 0;
    int end = 0;

    bool empty() const { return begin == end; }
};

struct PixelContent {
    PlanCell cell = PlanCell::nothing;
    float width = -1.0F;  // metres; negative if unknown
};

bool is_walkable(PlanCell cell) {
    return cell == PlanCell::reached || cell == PlanCell::no_return || cell == PlanCell::unreached;
}

// The cells whose middles lie in each pixel of a row or column; where cells are larger, the one that the
// pixel's middle lies in. `start` is the raster's in relation to the first pixel, metres.
std::vector<Span> cells_of_pixels(int pixels, double pixel_size, double start, double cell_size, int cells) {
    std::vector<Span> spans;
    spans.reserve(static_cast<std::size_t>(pixels));
    const auto clamped = [&](double index) { return static_cast<int>(std::clamp(index, 0.0, 1.0 * cells)); };
    for (int i = 0; i < pixels; ++i) {
        const double begin = (i * pixel_size - start) / cell_size;
        const double end = ((i + 1) * pixel_size - start) / cell_size;
        Span span{clamped(std::ceil(begin - 0.5)), clamped(std::ceil(end - 0.5))};
        if (span.empty()) {
            const double middle = std::floor(0.5 * (begin + end));
            span = {clamped(middle), clamped(middle + 1.0)};
        }
        spans.push_back(span);
    }
    return spans;
}

PixelContent content_of(const PlanRaster& raster, const Span& columns, const Span& rows) {
    if (columns.empty() || rows.empty()) {
        return {};
    }
    std::array<int, kByImportance.size()> counts{};
    std::array<float, kByImportance.size()> narrowest{};
    narrowest.fill(-1.0F);
    for (int row = rows.begin; row < rows.end; ++row) {
        for (int column = columns.begin; column < columns.end; ++column) {
            const std::size_t i = raster.index({column, row});
            const auto kind = static_cast<std::size_t>(raster.cells[i]);
            ++counts[kind];
            const float width = raster.widths.empty() ? -1.0F : raster.widths[i];
            if (width >= 0.0F && (narrowest[kind] < 0.0F || width < narrowest[kind])) {
                narrowest[kind] = width;
            }
        }
    }
    const PlanCell most = *std::ranges::max_element(
        kByImportance, {}, [&](PlanCell cell) { return counts[static_cast<std::size_t>(cell)]; });
    return {most, narrowest[static_cast<std::size_t>(most)]};
}

PlanColor color_at(const PixelContent& content, const StoreyPlan& plan, int x, int y) {
    if (content.cell == PlanCell::no_return && is_on_stripe(x, y)) {
        return kNoReturnStripe;
    }
    const bool reached = content.cell == PlanCell::reached || content.cell == PlanCell::no_return;
    if (reached && content.width >= 0.0F && content.width < plan.widest) {
        return width_color((content.width - plan.narrowest) / (plan.widest - plan.narrowest));
    }
    return color_of(content.cell);
}

PlanColor shaded(PlanColor color) {
    for (std::uint8_t& channel : color) {
        channel = static_cast<std::uint8_t>(std::lround(kRimShade * channel));
    }
    return color;
}

/// Draws what the raster has within `map`, in pixels of the image, which `frame` maps to the world. A pixel
/// that several cells share gets the kind of most of them. Walkable ground has a dark rim.
void draw_cells(const StoreyPlan& plan, const PlanFrame& frame, const Eigen::AlignedBox2i& map,
                Image& image) {
    const PlanRaster& raster = plan.raster;
    assert(raster.cells.size() ==
           static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows));
    assert(raster.widths.empty() || raster.widths.size() == raster.cells.size());
    const double pixel = 1.0 / frame.pixels_per_metre;
    const Eigen::Vector2i size = map.sizes();
    const Eigen::Vector2d start = raster.north_west - frame.north_west - pixel * map.min().cast<double>();
    const auto columns = cells_of_pixels(size.x(), pixel, start.x(), raster.cell_size, raster.columns);
    const auto rows = cells_of_pixels(size.y(), pixel, start.y(), raster.cell_size, raster.rows);
    std::vector<PixelContent> contents;
    contents.reserve(columns.size() * rows.size());
    for (const Span& row : rows) {
        for (const Span& column : columns) {
            contents.push_back(content_of(raster, column, row));
        }
    }
    const auto walkable = [&](int x, int y) {
        return x < 0 || y < 0 || x >= size.x() || y >= size.y() ||
               is_walkable(
                   contents[static_cast<std::size_t>(y) * columns.size() + static_cast<std::size_t>(x)].cell);
    };
    for (int y = 0; y < size.y(); ++y) {
        for (int x = 0; x < size.x(); ++x) {
            const PixelContent& here =
                contents[static_cast<std::size_t>(y) * columns.size() + static_cast<std::size_t>(x)];
            const bool rim = is_walkable(here.cell) && !(walkable(x - 1, y) && walkable(x + 1, y) &&
                                                         walkable(x, y - 1) && walkable(x, y + 1));
            const PlanColor inside = color_at(here, plan, x, y);
            const PlanColor color = rim ? shaded(color_of(here.cell)) : inside;
            std::ranges::copy(color, image.rgba.begin() + static_cast<std::ptrdiff_t>(image.offset(
                                                              map.min().x() + x, map.min().y() + y)));
        }
    }
}

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

// Pixels.
constexpr int kMargin = 20;
constexpr int kLeastLegend = 420;  // wide, right of a narrow map
constexpr int kLeastWidth = 760;   // of the image
constexpr double kTitle = 19.0;
constexpr double kSubtitle = 13.0;
constexpr double kCoordinate = 12.0;
constexpr double kLineDistance = 100.0;
constexpr int kCoordinateRow = 24;
constexpr int kLargest = 16384;  // a side; round_resolution() stays far below

constexpr double kLongestSide = 2100.0;  // of a map in round_resolution(); the shortest is 2/5 of it

constexpr Rgba kGridLine = {0.13, 0.14, 0.16, 0.20};
const TextStyle kCoordinateStyle = {kCoordinate, false, kFaintInk, 0.0, 1};

// Where things are, pixels.
struct PlanLayout {
    Eigen::AlignedBox2i map;
    PlanFrame frame;
    int width = 0;
    int map_bottom = 0;  // with its coordinates
    // The upper left pixel: below the map, or right of a narrow one.
    Eigen::Vector2i legend = Eigen::Vector2i::Zero();
    int legend_width = 0;
};

// Room left of the map for the longest coordinate.
int label_width(const Canvas& measure, const MapGrid& grid) {
    double width = 0.0;
    for (const MapGrid::Line& line : grid.z) {
        width = std::max(width, measure.text_size(line.label, kCoordinateStyle).x());
    }
    return static_cast<int>(std::ceil(width)) + 8;
}

AlignedBox2d pixels_of(const Eigen::AlignedBox2i& box) {
    return {box.min().cast<double>(), box.max().cast<double>()};
}

PlanLayout layout_of(const StoreyPlan& plan, const Canvas& measure) {
    PlanLayout layout;
    const double metres_per_pixel = plan.metres_per_pixel.value_or(round_resolution(plan.area));
    layout.frame = {plan.area.min(), 1.0 / metres_per_pixel};
    const Vector2d exact = plan.area.sizes() * layout.frame.pixels_per_metre;
    const Eigen::Vector2i size = exact.array().ceil().max(1.0).min(kLargest).cast<int>();
    const AlignedBox2d unplaced(Vector2d::Zero(), size.cast<double>());
    const int left = kMargin + label_width(measure, grid_across(layout.frame, unplaced, kLineDistance));
    const int top = kMargin + 28 + (plan.subtitle.empty() ? 0 : 20) + 8;
    layout.map = {Eigen::Vector2i(left, top), Eigen::Vector2i(left, top) + size};
    layout.frame.north_west -= metres_per_pixel * layout.map.min().cast<double>();
    layout.map_bottom = layout.map.max().y() + kCoordinateRow;
    const int right = layout.map.max().x() + kMargin;
    if (2 * size.y() > 3 * size.x()) {
        layout.width = std::max(kLeastWidth, right + kLeastLegend + kMargin);
        layout.legend = {right, top};
    } else {
        layout.width = std::max(kLeastWidth, right);
        layout.legend = {kMargin, layout.map_bottom + 12};
    }
    layout.legend_width = layout.width - kMargin - layout.legend.x();
    return layout;
}

void draw_plan_grid(const Canvas& canvas, const MapGrid& grid, const AlignedBox2d& map) {
    cairo_t* cr = canvas.cairo();
    for (const MapGrid::Line& line : grid.x) {
        cairo_move_to(cr, std::floor(line.pixel) + 0.5, map.min().y());
        cairo_line_to(cr, std::floor(line.pixel) + 0.5, map.max().y());
    }
    for (const MapGrid::Line& line : grid.z) {
        cairo_move_to(cr, map.min().x(), std::floor(line.pixel) + 0.5);
        cairo_line_to(cr, map.max().x(), std::floor(line.pixel) + 0.5);
    }
    canvas.set_color(kGridLine);
    cairo_set_line_width(cr, 1.0);
    cairo_stroke(cr);
    const Vector2d upper_left = map.min() - Vector2d(0.5, 0.5);
    const Vector2d size = map.sizes() + Vector2d(1.0, 1.0);
    cairo_rectangle(cr, upper_left.x(), upper_left.y(), size.x(), size.y());
    canvas.set_color(kFaintInk);
    cairo_stroke(cr);
}

// Below the map and left of it.
void draw_coordinates_beside(const Canvas& canvas, const MapGrid& grid, const AlignedBox2d& map) {
    double free_from = 0.0;
    for (const MapGrid::Line& line : grid.x) {
        const double half = 0.5 * canvas.text_size(line.label, kCoordinateStyle).x();
        if (line.pixel - half >= free_from) {
            canvas.text(line.pixel - half, map.max().y() + 5.0, line.label, kCoordinateStyle);
            free_from = line.pixel + half + 6.0;
        }
    }
    for (const MapGrid::Line& line : grid.z) {
        const Vector2d size = canvas.text_size(line.label, kCoordinateStyle);
        canvas.text(map.min().x() - 6.0 - size.x(), line.pixel - 0.5 * size.y(), line.label,
                    kCoordinateStyle);
    }
}

void draw_titles(const Canvas& canvas, const StoreyPlan& plan) {
    const double width = canvas.width() - 2.0 * kMargin;
    canvas.text(kMargin, kMargin - 2.0, plan.title, {kTitle, true, kInk, width, 1});
    if (!plan.subtitle.empty()) {
        canvas.text(kMargin, kMargin + 26.0, plan.subtitle, {kSubtitle, false, kFaintInk, width, 1});
    }
}

}  // namespace

PlanColor width_color(double share) {
    static constexpr std::array<PlanColor, 3> kRamp = {{{106, 0, 104}, {129, 85, 170}, {140, 160, 215}}};
    const double at = std::clamp(share, 0.0, 1.0) * (kRamp.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(at), kRamp.size() - 2);
    const double part = at - static_cast<double>(i);
    PlanColor color{};
    for (std::size_t channel = 0; channel < color.size(); ++channel) {
        color[channel] = static_cast<std::uint8_t>(
            std::lround((1.0 - part) * kRamp[i][channel] + part * kRamp[i + 1][channel]));
    }
    return color;
}

double round_resolution(const Eigen::AlignedBox2d& area) {
    const double longest = std::max(area.sizes().maxCoeff(), 1e-3);
    return 1.0 / round_length(kLongestSide / longest);
}

Image draw_storey_plan(const StoreyPlan& plan) {
    assert(!plan.area.isEmpty());
    const Fonts fonts;
    const Canvas measure(Image::filled(1, 1), fonts);
    const PlanLayout layout = layout_of(plan, measure);
    const AlignedBox2d map = pixels_of(layout.map);
    const MapGrid grid = grid_across(layout.frame, map, kLineDistance);
    const PlanLegend legend(measure, plan, "grid " + length_text(grid.spacing) + ", north (-z) up",
                            layout.legend_width);
    const int legend_bottom = layout.legend.y() + static_cast<int>(std::ceil(legend.height()));
    Image image = Image::filled(layout.width, std::max(layout.map_bottom, legend_bottom) + kMargin, 255);
    draw_cells(plan, layout.frame, layout.map, image);
    const Canvas canvas(image, fonts);
    draw_plan_grid(canvas, grid, map);
    draw_coordinates_beside(canvas, grid, map);
    draw_titles(canvas, plan);
    draw_plan_marks(canvas, plan, layout.frame, map);
    legend.draw(canvas, layout.legend.cast<double>());
    return canvas.image();
}

Image draw_storey_plans(std::span<const StoreyPlan> plans) {
    std::vector<Image> images;
    int width = 0;
    int height = 0;
    for (const StoreyPlan& plan : plans) {
        images.push_back(draw_storey_plan(plan));
        width = std::max(width, images.back().width);
        height += images.back().height;
    }
    Image all = Image::filled(width, height, 255);
    int top = 0;
    for (const Image& image : images) {
        const std::size_t row = image.offset(0, 1);
        for (int y = 0; y < image.height; ++y) {
            std::copy_n(&image.rgba[image.offset(0, y)], row, &all.rgba[all.offset(0, top + y)]);
        }
        top += image.height;
    }
    return all;
}

}  // namespace campuswalk::engine::render
