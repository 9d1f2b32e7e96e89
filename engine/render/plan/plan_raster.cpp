#include "engine/render/plan/plan_raster.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

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

}  // namespace campuswalk::engine::render
