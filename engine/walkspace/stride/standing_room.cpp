#include "engine/walkspace/stride/standing_room.h"

#include <cmath>
#include <vector>

#include "collision/world/obstacle.h"
#include "collision/world/placement.h"
#include "engine/script/travel.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// A body that is this much thinner, at the nearest sample, lies within the body wherever that stands,
/// metres.
constexpr double kThinner = 0.1;
/// Samples are this far apart along each axis: none is farther from a point between than kThinner.
constexpr double kApart = 2.0 * kThinner / 1.7320508075688772;

/// Whether a solid is where something that carries the body would have to be.
bool has_ground(const collision::World& world, const collision::QueryFilter& solids,
                const collision::MoverSettings& body, const Target& target, double within) {
    const Vec3 lowest = target.point + Vec3(0.0, body.radius - kTargetLevel, 0.0);
    const Vec3 highest = target.point + Vec3(0.0, body.radius + kTargetLevel, 0.0);
    std::vector<collision::Obstacle> near;
    collision::gather_obstacles(world, solids, {lowest, highest}, body.radius + within + kThinner, near);
    return !near.empty();
}

}  // namespace

bool may_stand_at(const collision::World& world, const collision::QueryFilter& solids,
                  const collision::MoverSettings& body, const Target& target, double within) {
    if (!target.has_height || body.radius <= kThinner) {
        return true;
    }
    if (!has_ground(world, solids, body, target, within)) {
        return false;
    }
    const auto across = static_cast<int>(std::ceil(within / kApart - 0.5));
    const auto up = static_cast<int>(std::ceil(kTargetLevel / kApart - 0.5));
    for (int i = -across; i <= across; ++i) {
        for (int j = -across; j <= across; ++j) {
            for (int k = -up; k <= up; ++k) {
                const Vec3 core = target.point + kApart * Vec3(i, k, j) + kThinner * Vec3::UnitY();
                if (!collision::obstruction(world, solids, core, body.radius - kThinner,
                                            body.height - 2.0 * kThinner)) {
                    return true;
                }
            }
        }
    }
    return false;
}

}  // namespace campuswalk::engine
