#include "collision/mover/open_floor.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "collision/mover/mover.h"
#include "collision/world/bullet_broad_phase.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/random_scene.h"

/// A mover that knows open floors against one that has just been made, for which there are none.
namespace campuswalk::collision {
namespace {

using support::Dice;

constexpr double kTick = 1.0 / 60.0;

/// A hall with what floors are made of: two triangles or tiles, a ramp, back faces, a carpet, kerbs, walls,
/// a gallery, and a pit that has no floor.
std::unique_ptr<World> make_hall() {
    auto world = std::make_unique<World>(make_bullet_broad_phase());
    TriangleMesh mesh;
    support::add_quad(mesh, {-10, 0, 0}, {-10, 0, 10}, {6, 0, 10}, {6, 0, 0});
    support::add_quad(mesh, {-10, 0, 10}, {-10, 0, 0}, {6, 0, 0}, {6, 0, 10});  // its back
    for (int x = -10; x < 0; ++x) {
        support::add_quad(mesh, {x * 1.0, 0, -10}, {x * 1.0, 0, 0}, {x + 1.0, 0, 0}, {x + 1.0, 0, -10});
    }
    support::add_quad(mesh, {0, 0, 0}, {10, 3, 0}, {10, 3, -10}, {0, 0, -10});
    support::add_quad(mesh, {-8, 0.004, 2}, {-8, 0.004, 6}, {-4, 0.004, 6}, {-4, 0.004, 2});
    support::add_box(mesh, {-1, 0, 4}, {3, 0.12, 9});
    support::add_box(mesh, {-6, 0, -6}, {-5, 1, -5});
    support::add_room(mesh, {-9.5, 0, -9.5}, {9.5, 4, 9.5}, 1.2);
    support::add_object(*world, std::move(mesh));
    support::add_object(*world, Sphere{0.5}, {-3, 0.3, -3});
    support::add_object(*world, Box{{0.4, 0.1, 0.4}}, {-7, 2.0, -8});
    return world;
}

struct Walked {
    int open = 0;  ///< ticks
    int ticks = 0;
};

/// Walks and runs for some ticks in each of many directions, and compares every tick.
Walked compare_on(const World& world, const MoverSettings& body, std::uint32_t seed, double half, int ticks) {
    Dice dice(seed);
    const CapsuleMover mover(world, body, {});
    MoverCache warm;
    MoveTrace trace;
    MoverState state;
    mover.place(state, support::random_free_place(world, dice, half), 5.0, warm);
    Walked walked;
    Vec3 desired = Vec3::Zero();
    for (int i = 0; i < ticks && state.foot.y() > -50.0; ++i) {
        if (i % 40 == 0) {
            const double angle = dice.between(0, 6.3);
            const double speed = dice.between(0, 1) < 0.8 ? 1.4 : 2.8;
            desired = speed * kTick * Vec3(std::cos(angle), 0, std::sin(angle));
        }
        MoverState fresh_state = state;
        MoverCache fresh;
        MoveTrace fresh_trace;
        mover.move(fresh_state, desired, kTick, fresh, fresh_trace);
        if (state.grounded) {
            if (const auto place = warm.floors.walk(body, state.foot, desired)) {
                ++walked.open;
                EXPECT_EQ(place->foot, fresh_state.foot);
            }
        }
        if (i % 7 == 0) {
            mover.advance(state, desired, kTick, warm, trace);
        } else {
            mover.move(state, desired, kTick, warm, trace);
            EXPECT_EQ(trace.touching.size(), fresh_trace.touching.size());
        }
        EXPECT_EQ(trace.path, fresh_trace.path);
        EXPECT_TRUE(state == fresh_state)
            << "seed " << seed << ", tick " << i << " at " << fresh_state.foot.transpose();
        if (::testing::Test::HasFailure()) {
            return walked;
        }
        ++walked.ticks;
    }
    return walked;
}

TEST(OpenFloors, LeadToWhereTheQueriesLead) {
    for (const double skin : {0.02, 0.0}) {
        MoverSettings body;
        body.skin = skin;
        Walked all;
        for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(support::repeats(40)); ++seed) {
            const Walked walked = compare_on(*make_hall(), body, seed, 8.0, 600);
            ASSERT_FALSE(HasFailure());
            all.open += walked.open;
            all.ticks += walked.ticks;
        }
        EXPECT_GT(all.open, all.ticks / 10) << "there were some";
    }
}

TEST(OpenFloors, ChangeNothingOnRollingGround) {
    int open = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(support::repeats(20)); ++seed) {
        Dice dice(seed);
        const auto village = support::make_random_village(dice);
        open += compare_on(*village, {}, seed, 8.0, 600).open;
        ASSERT_FALSE(HasFailure());
    }
    EXPECT_GT(open, support::repeats(200));
}

TEST(OpenFloors, AreForgottenWithTheCache) {
    World world(make_bullet_broad_phase());
    TriangleMesh floor;
    support::add_floor(floor, 20.0);
    support::add_object(world, std::move(floor));
    const MoverSettings body;
    const CapsuleMover mover(world, body, {});
    MoverCache cache;
    MoverState state;
    MoveTrace trace;
    mover.place(state, {3, 0.1, 1}, 1.0, cache);
    const Vec3 desired(0.02, 0, 0);
    mover.move(state, desired, kTick, cache, trace);
    EXPECT_TRUE(cache.floors.walk(body, state.foot, desired));
    EXPECT_FALSE(cache.floors.walk(body, state.foot, 10.0 * desired)) << "faster than it was tried";
    EXPECT_FALSE(cache.floors.walk(body, state.foot + Vec3(0, 0.01, 0), desired)) << "it doesn't stand there";
    EXPECT_FALSE(cache.floors.walk(body, state.foot + Vec3(5, 0, 0), desired)) << "not known so far away";
    cache.clear();
    EXPECT_FALSE(cache.floors.walk(body, state.foot, desired));
}

}  // namespace
}  // namespace campuswalk::collision
