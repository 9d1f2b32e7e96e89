#include "tests/tools/campuswalk_bench/procedural/placement_flood_fill.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace campuswalk::tools::bench {

namespace {

using support::Line;
using support::Vertices;
using Point = StandingFlood::Point;

constexpr double kSame = 0.02;  ///< metres; levels this close count as one
constexpr std::pair<int, int> kNeighbours[] = {{1, 0},  {1, 1},   {0, 1},  {-1, 1},
                                               {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};

double level_distance(const Point& a, const Point& b) {
    return Point(a.x() - b.x(), 0.0, a.z() - b.z()).norm();
}

}  // namespace

StandingFlood::StandingFlood(const collision::TriangleMesh& mesh, const FloodBody& body, double cell)
    : body_(body), cell_(cell) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const collision::Triangle t = vertices(mesh, i);
        grid_.add(0, {t.a, t.b, t.c});
    }
    grid_.sort_into_columns();
}

bool StandingFlood::leads(const Point& from, const Point& to, double aside) {
    start_at(from);
    const Line straight{{from.x(), 0.0, from.z()}, {to.x(), 0.0, to.z()}};
    std::vector<Place> open;
    const auto visit = [&](const Cell& cell, std::size_t level) {
        std::vector<Level>& there = levels(cell);
        if (level < there.size() && there[level].walkable && there[level].fits && !there[level].seen &&
            distance(center(cell, 0.0), straight) <= aside) {
            there[level].seen = true;
            open.emplace_back(cell, level);
        }
    };
    visit({0, 0}, level_at({0, 0}, from.y()));
    while (!open.empty()) {
        const auto [cell, index] = open.back();
        open.pop_back();
        const Level level = levels(cell)[index];
        if (level_distance(center(cell, 0.0), to) <= 0.1 && std::abs(level.y - to.y()) <= 0.1) {
            return true;
        }
        for (const Cell& direction : kNeighbours) {
            const auto [beside, there] = step(cell, level, direction);
            visit(beside, there);
        }
    }
    return false;
}

StandingFlood::Place StandingFlood::step(const Cell& cell, const Level& level, const Cell& direction) {
    const int farthest = static_cast<int>(2.0 * body_.radius / cell_) + 1;
    for (int i = 1; i <= farthest; ++i) {
        const Cell beside{cell.first + i * direction.first, cell.second + i * direction.second};
        const std::size_t index = next(level, beside);
        const std::vector<Level>& there = levels(beside);
        const bool over_a_drop = index < there.size() && there[index].y < level.y - body_.step;
        if (!over_a_drop || there[index].fits || !fits(center(beside, level.y))) {
            return {beside, index};
        }
    }
    return {cell, levels(cell).size()};
}

bool StandingFlood::is_open(const Point& to, double far) {
    start_at(to);
    std::vector<Place> open;
    const auto visit = [&](const Cell& cell, std::size_t index) {
        Level& level = levels(cell)[index];
        if (level.fits && !level.seen) {
            level.seen = true;
            open.emplace_back(cell, index);
        }
    };
    visit({0, 0}, level_at({0, 0}, to.y()));
    while (!open.empty()) {
        const auto [cell, index] = open.back();
        open.pop_back();
        if (level_distance(center(cell, 0.0), to) >= far) {
            return true;
        }
        for (const auto& [x, z] : kNeighbours) {
            const Cell beside{cell.first + x, cell.second + z};
            for (std::size_t before = 0; before < levels(beside).size(); ++before) {
                if (next(levels(beside)[before], cell) == index) {
                    visit(beside, before);
                }
            }
        }
    }
    return false;
}

void StandingFlood::start_at(const Point& origin) {
    origin_ = origin;
    columns_.clear();
}

Point StandingFlood::center(const Cell& cell, double y) const {
    return {origin_.x() + cell_ * cell.first, y, origin_.z() + cell_ * cell.second};
}

std::vector<StandingFlood::Level>& StandingFlood::levels(const Cell& cell) {
    const auto [at, is_new] = columns_.try_emplace(cell);
    std::vector<Level>& found = at->second;
    if (!is_new) {
        return found;
    }
    const Point low = center(cell, -1000.0);
    const Point high = center(cell, 1000.0);
    grid_.visit_near(low, high, [&](const support::TriangleGrid::Entry& e) {
        const Point normal = (e.vertices[1] - e.vertices[0]).cross(e.vertices[2] - e.vertices[0]);
        const double up = std::abs(normal.y()) / normal.norm();
        if (up > 1e-3 && support::passes_through({low, high}, e.vertices)) {
            const double y = e.vertices[0].y() - ((low.x() - e.vertices[0].x()) * normal.x() +
                                                  (low.z() - e.vertices[0].z()) * normal.z()) /
                                                     normal.y();
            found.push_back({y, up >= body_.min_up, fits({low.x(), y, low.z()}), false});
        }
    });
    std::sort(found.begin(), found.end(), [](const Level& a, const Level& b) { return a.y < b.y; });
    return found;
}

bool StandingFlood::fits(const Point& foot) const {
    const Line axis{foot + Point(0.0, body_.step + body_.radius, 0.0),
                    foot + Point(0.0, body_.height - body_.radius, 0.0)};
    const Point grown = Point::Constant(body_.radius);
    bool free = true;
    grid_.visit_near(axis.from - grown, axis.to + grown, [&](const support::TriangleGrid::Entry& e) {
        free = free && distance(axis, e.vertices) >= body_.radius;
    });
    return free;
}

std::size_t StandingFlood::next(const Level& level, const Cell& cell) {
    const std::vector<Level>& there = levels(cell);
    const double highest = level.y + (level.walkable ? body_.step : 0.0);
    const auto above = std::partition_point(there.begin(), there.end(),
                                            [&](const Level& other) { return other.y <= highest; });
    return above == there.begin() ? there.size() : static_cast<std::size_t>(above - there.begin()) - 1;
}

std::size_t StandingFlood::level_at(const Cell& cell, double y) {
    const std::vector<Level>& there = levels(cell);
    std::size_t best = there.size();
    for (std::size_t i = 0; i < there.size(); ++i) {
        if (std::abs(there[i].y - y) <= kSame) {
            best = i;  // the uppermost of several, as in `next`
        }
    }
    return best;
}

}  // namespace campuswalk::tools::bench
