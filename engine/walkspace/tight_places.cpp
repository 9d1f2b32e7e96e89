#include "engine/walkspace/tight_places.h"

#include <algorithm>
#include <vector>

#include "collision/world/obstacle.h"

namespace campuswalk::engine {

namespace {

constexpr double kRoomBeside = 0.4;  // metres
/// What rises less than this above a step is still one, metres.
constexpr double kAboveStep = 0.02;

}  // namespace

std::function<bool(const collision::Vec3& foot)> tight_places(const collision::World& world,
                                                              const collision::QueryFilter& solids,
                                                              const collision::MoverSettings& body) {
    return [&world, solids, body,
            near = std::vector<collision::Obstacle>()](const collision::Vec3& foot) mutable {
        const collision::Vec3 step(0, body.step_height, 0);
        const collision::Segment core{body.core(foot).a + step, body.core(foot).b};
        const double top_of_step = foot.y() + body.step_height + kAboveStep;
        collision::gather_obstacles(world, solids, core, body.radius + kRoomBeside, near);
        return std::ranges::any_of(near, [&](const collision::Obstacle& piece) {
            return collision::closest(core, piece).on_shape.y() > top_of_step;
        });
    };
}

}  // namespace campuswalk::engine
