#include "tests/collision/course/course_scene.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/angles.h"

namespace campuswalk::collision::course {

Vec3 towards(double degrees) {
    return {std::cos(support::radians(degrees)), 0.0, -std::sin(support::radians(degrees))};
}

std::unique_ptr<World> empty_world() {
    return std::make_unique<World>(std::make_unique<LinearBroadPhase>());
}

std::unique_ptr<World> floor_world() {
    auto world = empty_world();
    TriangleMesh floor;
    support::add_floor(floor, 20.0);
    support::add_object(*world, std::move(floor));
    return world;
}

double jitter(AuditedBody& body, const Vec3& velocity, double seconds) {
    const Vec3 settled = body.foot();
    double worst = 0.0;
    const int ticks = static_cast<int>(std::lround(seconds * body.ticks_per_second));
    for (int i = 0; i < ticks && !::testing::Test::HasFatalFailure(); ++i) {
        body.tick(velocity);
        worst = std::max(worst, (body.foot() - settled).norm());
    }
    return worst;
}

bool reach(AuditedBody& body, const Vec3& goal, double speed, double seconds) {
    const int ticks = static_cast<int>(std::lround(seconds * body.ticks_per_second));
    for (int i = 0; i < ticks && !::testing::Test::HasFatalFailure(); ++i) {
        Vec3 to_goal = goal - body.foot();
        to_goal.y() = 0.0;
        const double far = to_goal.norm();
        if (far <= 0.05) {
            return true;
        }
        body.tick(std::min(speed, far * body.ticks_per_second) / far * to_goal);
    }
    return false;
}

}  // namespace campuswalk::collision::course
