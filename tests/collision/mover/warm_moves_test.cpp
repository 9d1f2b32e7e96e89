#include <gtest/gtest.h>

#include "collision/mover/mover.h"
#include "tests/collision/allocation_count.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/random_scene.h"

/// Repeating a walk allocates nothing.
namespace campuswalk::collision {
namespace {

using support::Dice;

/// Walks, falls, jumps and crouches among all kinds of obstacles.
void wander(CapsuleMover mover, MoverState& state, MoverCache& cache, MoveTrace& trace, double speed,
            int ticks) {
    Dice dice(4);
    Vec3 velocity = Vec3::Zero();
    for (int i = 0; i < ticks; ++i) {
        if (i % 40 == 0) {
            velocity = speed * Vec3(dice.between(-1, 1), 0, dice.between(-1, 1));
            mover.jump(state, 4.0);
        }
        if (i % 60 == 0) {
            mover = mover.resized(state, i % 120 == 0 ? 1.2 : 1.8, cache).value_or(mover);
        }
        mover.move(state, velocity / 60.0, 1.0 / 60.0, cache, trace);
    }
}

TEST(WarmMoves, AllocateNothing) {
    for (const bool soup : {true, false}) {
        for (const double speed : {1.4, 40.0}) {
            Dice dice(2);
            const auto world = soup ? support::make_soup(dice) : support::make_random_village(dice);
            const CapsuleMover mover(*world, {}, {});
            MoverCache cache;
            MoverState start;
            start.foot = support::random_free_place(*world, dice, support::kSoupHalf);
            MoveTrace trace;
            const int ticks = support::repeats(2000);
            MoverState state = start;
            wander(mover, state, cache, trace, speed, ticks);
            const Vec3 end = state.foot;
            cache.clear();
            state = start;
            const std::size_t before = allocation_count();
            wander(mover, state, cache, trace, speed, ticks);
            EXPECT_EQ(allocation_count() - before, 0U) << (soup ? "soup" : "village") << ", " << speed;
            EXPECT_GT((end - start.foot).norm(), 0.1) << "the body moved";
        }
    }
}

}  // namespace
}  // namespace campuswalk::collision
