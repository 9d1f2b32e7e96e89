#include "engine/walkspace/report/triangle_density.h"

#include <algorithm>
#include <cmath>

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// Edge lengths of a cell, metres: as far as the mover looks about, and as high as a body.
constexpr double kWidth = 1.0;
constexpr double kHeight = 2.0;

}  // namespace

TriangleDensity::TriangleDensity(const collision::World& world) {
    std::vector<Cell> cells;
    visit_triangles(world, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        cells.push_back(cell_at((a + b + c) / 3.0));
    });
    std::ranges::sort(cells);
    for (const Cell& cell : cells) {
        if (counts_.empty() || counts_.back().cell != cell) {
            counts_.push_back({cell});
        }
        ++counts_.back().triangles;
    }
}

double TriangleDensity::around(const Vec3& foot) const {
    const Cell middle = cell_at(foot);
    std::uint32_t triangles = 0;
    for (int x = -1; x <= 1; ++x) {
        for (int z = -1; z <= 1; ++z) {
            for (int y = 0; y <= 1; ++y) {
                triangles += count_in({middle[0] + x, middle[1] + z, middle[2] + y});
            }
        }
    }
    return triangles;
}

TriangleDensity::Cell TriangleDensity::cell_at(const Vec3& point) {
    const auto number = [](double at, double size) { return static_cast<int>(std::floor(at / size)); };
    return {number(point.x(), kWidth), number(point.z(), kWidth), number(point.y(), kHeight)};
}

std::uint32_t TriangleDensity::count_in(const Cell& cell) const {
    const auto found = std::ranges::lower_bound(counts_, cell, {}, &Count::cell);
    return found != counts_.end() && found->cell == cell ? found->triangles : 0;
}

}  // namespace campuswalk::engine
