#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "collision/world/world.h"
#include "tests/support/plain_geometry.h"
#include "tests/support/triangle_grid.h"

namespace campuswalk::support {

/// The avatar's deepest penetration.
struct Penetration {
    /// Metres, positive when they overlap; negative is the gap, cut at PenetrationOracle::kClear.
    double depth = 0.0;
    std::optional<std::size_t> object;  ///< its number in the world; none when nothing is within kClear
};

/// Says whether an upright capsule is inside the solid objects of a world, by brute force over all of them.
/// It uses the world's vertices and numbers and nothing else of collision/. A mesh is its surface: a body
/// that starts outside a closed mesh can't get in without `crossed` noticing. Convex solids are filled.
class PenetrationOracle {
public:
    static constexpr double kClear = 0.05;  ///< gaps are measured up to this, metres

    explicit PenetrationOracle(const collision::World& world, const collision::QueryFilter& filter = {});

    /// `foot` is the capsule's lowest point, `height` its total height.
    Penetration worst_penetration(const Point& foot, double radius, double height) const;
    /// The same by a loop over everything, for testing the oracle.
    Penetration worst_penetration_without_grid(const Point& foot, double radius, double height) const;

    /// The object that the capsule's axis passes through while the foot goes straight from `from` to `to`:
    /// what a body tunnels through if it is beyond a wall after a tick. For moves longer than the radius,
    /// call it for each straight segment.
    std::optional<std::size_t> crossed(const Point& from, const Point& to, double radius,
                                       double height) const;

    std::size_t triangle_count() const { return grid_.entries().size(); }

private:
    struct Solid {
        std::size_t object = 0;
        const collision::Object* shape = nullptr;
        double reach = 0.0;  ///< from the centre to the farthest point
    };

    void add_mesh(std::size_t object, const collision::Object& mesh);

    TriangleGrid grid_;
    std::vector<Solid> solids_;
};

}  // namespace campuswalk::support
