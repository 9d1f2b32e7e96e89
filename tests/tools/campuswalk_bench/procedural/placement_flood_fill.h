#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "collision/geometry/triangle_mesh.h"
#include "tests/support/plain_geometry.h"
#include "tests/support/triangle_grid.h"

namespace campuswalk::tools::bench {

/// The size and abilities of the walker.
struct FloodBody {
    double radius = 0.3;
    double height = 1.8;
    double step = 0.3;
    double min_up = 0.6427876096865393;  ///< cosine of the steepest walkable slope
};

/// A flood fill of the placements that a walker can reach in a mesh, independent of the mover: places are
/// surfaces at the centres of square cells where an upright capsule, from step height up, is clear of all
/// triangles. From a place the walker gets to the highest surface of an adjacent cell that is at most a step
/// above, at any depth below; from a steep one never upwards.
class StandingFlood {
public:
    using Point = support::Point;

    StandingFlood(const collision::TriangleMesh& mesh, const FloodBody& body, double cell);

    /// Whether `to` can be reached from `from` on walkable ground within `aside` metres of the straight line.
    /// The grid is aligned to `from`.
    bool leads(const Point& from, const Point& to, double aside);

    /// Whether `to` can be reached on any path, including steep ground, from a distance of `far` metres.
    /// Paths over drops are not found: the flood goes backwards from `to`.
    bool is_open(const Point& to, double far);

private:
    struct Level {
        double y = 0.0;
        bool walkable = false;
        bool fits = false;
        bool seen = false;
    };
    using Cell = std::pair<int, int>;
    using Place = std::pair<Cell, std::size_t>;

    void start_at(const Point& origin);
    Point center(const Cell& cell, double y) const;
    std::vector<Level>& levels(const Cell& cell);
    bool fits(const Point& foot) const;
    /// The place after a step in a direction. Beyond an edge, continues at the old height until the capsule
    /// is clear of what is below.
    Place step(const Cell& cell, const Level& level, const Cell& direction);
    /// The index of the level of `cell` that is reached from `level` of an adjacent cell; the number of
    /// levels if none is.
    std::size_t next(const Level& level, const Cell& cell);
    /// The index of the level at a height; the number of levels if there is none.
    std::size_t level_at(const Cell& cell, double y);

    FloodBody body_;
    double cell_;
    Point origin_ = Point::Zero();
    support::TriangleGrid grid_;
    std::map<Cell, std::vector<Level>> columns_;
};

}  // namespace campuswalk::tools::bench
