#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "collision/geometry/triangle_mesh.h"
#include "tests/support/plain_geometry.h"
#include "tests/support/triangle_grid.h"

namespace campuswalk::scene {

/// Who is on the way.
struct FloodBody {
    double radius = 0.3;
    double height = 1.8;
    double step = 0.3;
    double min_up = 0.6427876096865393;  ///< cosine of the steepest slope that is climbed
};

/// Finds where a person gets to in a mesh, knowing nothing of movers: places are surfaces above the middles
/// of square cells where an upright capsule, above the height of a step, is clear of all triangles. From one
/// a person gets to the highest surface of a neighbouring cell that is no more than a step above, however
/// deep that is below; from a steep one not upwards.
class StandingFlood {
public:
    using Point = support::Point;

    StandingFlood(const collision::TriangleMesh& mesh, const FloodBody& body, double cell);

    /// Whether one gets from `from` to `to` on walkable ground without leaving what is within `aside` metres
    /// of the straight line. Cells are counted from `from`.
    bool leads(const Point& from, const Point& to, double aside);

    /// Whether, on whatever way, steep ground included, one gets to `to` from as far as `far` metres from it.
    /// Not past edges that one falls from: see who gets there.
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
    Point middle(const Cell& cell, double y) const;
    std::vector<Level>& levels(const Cell& cell);
    bool fits(const Point& foot) const;
    /// Where one is after a step in a direction. Past an edge there is no standing until one is clear of what
    /// is below it: one goes on at the old height until then.
    Place step(const Cell& cell, const Level& level, const Cell& way);
    /// The level of `cell` that one comes to from `level` of a cell beside it; as many as there are if to
    /// none.
    std::size_t next(const Level& level, const Cell& cell);
    /// The level at a point; as many as there are if there is none.
    std::size_t level_at(const Cell& cell, double y);

    FloodBody body_;
    double cell_;
    Point origin_ = Point::Zero();
    support::TriangleGrid grid_;
    std::map<Cell, std::vector<Level>> columns_;
};

}  // namespace campuswalk::scene
