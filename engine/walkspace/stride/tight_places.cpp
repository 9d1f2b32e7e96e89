#include "engine/walkspace/stride/tight_places.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "collision/world/obstacle.h"

namespace campuswalk::engine {

namespace {

constexpr double kRoomBeside = 0.4;  // metres
/// What is farther above or below than this share of how far it is aside isn't beside.
constexpr double kHowLevel = 0.5;

}  // namespace

std::function<bool(const collision::Vec3& foot)> tight_places(const collision::World& world,
                                                              const collision::QueryFilter& solids,
                                                              const collision::MoverSettings& body) {
    return [&world, solids, body,
            near = std::vector<collision::Obstacle>()](const collision::Vec3& foot) mutable {
        const collision::Vec3 waist = foot + collision::Vec3(0, 0.5 * body.height, 0);
        const collision::Segment spine{waist, foot + collision::Vec3(0, body.height, 0)};
        collision::gather_obstacles(world, solids, spine, body.radius + kRoomBeside, near);
        return std::ranges::any_of(near, [&](const collision::Obstacle& piece) {
            const collision::Closest c = collision::closest(spine, piece);
            const collision::Vec3 gap = c.on_shape - c.on_segment;
            return std::abs(gap.y()) <= kHowLevel * collision::horizontal_norm(gap);
        });
    };
}

}  // namespace campuswalk::engine
