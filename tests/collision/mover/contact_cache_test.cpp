#include "collision/mover/contact_cache.h"

#include <algorithm>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "collision/mover/mover.h"
#include "tests/support/effort.h"
#include "tests/support/plain_geometry.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;
using PieceId = std::pair<ObjectId, std::uint32_t>;

/// A survey around a random place.
struct Look {
    Vec3 foot;
    double sideways = 0.0;
    double up = 0.0;
    double down = 0.0;
    double reach = 0.0;

    explicit Look(Dice& dice)
        : foot(dice.between(-4, 4), dice.between(0, 2), dice.between(-4, 4)),
          sideways(dice.between(0, 0.3)),
          up(dice.between(0, 0.4)),
          down(dice.between(0, 0.4)),
          reach(dice.between(0, 0.05)) {}

    Aabb box(const MoverSettings& body) const {
        const double r = body.radius + sideways + reach;
        return {foot - Vec3(r, down + reach, r), foot + Vec3(r, body.height + up + reach, r)};
    }
    Vec3 somewhere(Dice& dice) const {
        const double angle = dice.between(0, 6.3);
        const double far = dice.between(0, sideways);
        return foot + Vec3(far * std::cos(angle), dice.between(-down, up), far * std::sin(angle));
    }
};

TEST(ContactCache, ASurveyMissesNothingWithinReach) {
    const MoverSettings body;
    int in_reach = 0;
    int apart = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(support::repeats(20)); ++seed) {
        Dice dice(seed);
        const auto world = support::make_soup(dice);
        ContactCache around;
        around.prepare(*world, body, {});
        for (int i = 0; i < 100; ++i) {
            const Look look(dice);
            around.cover(look.box(body));
            const auto found = around.survey(look.foot, look.sideways, look.up, look.down, look.reach);
            const std::set<ContactCache::Index> near(found.begin(), found.end());
            const Vec3 place = look.somewhere(dice);
            for (ContactCache::Index k = 0; k < around.pieces().size(); ++k) {
                const Obstacle& o = around.piece(k).obstacle;
                const double distance = closest(body.core(place), o).distance;
                if (distance <= body.radius + look.reach) {
                    ASSERT_TRUE(near.contains(k)) << "seed " << seed << ", look " << i;
                    ++in_reach;
                }
                ASSERT_GE(distance, around.known_distance(k, place) - 1e-9);
                ASSERT_GE(distance, around.measure(k, look.foot).bound(place) - 1e-9);
                ASSERT_GE(distance, around.known_distance(k, place) - 1e-9);
                if (around.known_apart(k, look.foot, place, body.radius)) {
                    ++apart;
                    const Vec3 between = 0.5 * (look.foot + place);
                    ASSERT_GE(closest(body.core(between), o).distance, body.radius - 1e-9);
                }
            }
        }
    }
    EXPECT_GT(in_reach, support::repeats(1000));
    EXPECT_GT(apart, support::repeats(1000));
}

TEST(ContactCache, HoldsEveryTriangleOfTheCoveredBox) {
    const MoverSettings body;
    Dice dice(7);
    const auto world = support::make_random_village(dice);
    ContactCache around;
    around.prepare(*world, body, {});
    for (int i = 0; i < 50; ++i) {
        const Look look(dice);
        const Aabb box = look.box(body);
        around.cover(box);
        std::set<PieceId> held;
        for (const ContactCache::Piece& piece : around.pieces()) {
            held.emplace(piece.obstacle.object, piece.obstacle.triangle);
        }
        std::vector<Obstacle> expected;
        gather_obstacles(*world, {}, body.core(look.foot), body.radius + look.sideways, expected);
        for (const Obstacle& o : expected) {
            const bool is_box = o.solid != nullptr && std::holds_alternative<Box>(o.solid->shape);
            ASSERT_TRUE(is_box || held.contains({o.object, o.triangle})) << i;
        }
    }
}

/// Covering a further box neither loses triangles nor adds them twice.
TEST(ContactCache, HoldsEveryTriangleOnceOnALongWalk) {
    const MoverSettings body;
    int held_in_total = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(support::repeats(12)); ++seed) {
        Dice dice(seed);
        const auto world = seed % 2 == 0 ? support::make_soup(dice) : support::make_random_village(dice);
        ContactCache around;
        around.prepare(*world, body, {});
        Vec3 foot(dice.between(-3, 3), dice.between(0, 1), dice.between(-3, 3));
        Vec3 step = Vec3::Zero();
        for (int i = 0; i < 200; ++i) {
            if (i % 20 == 0) {
                const double x = dice.between(-0.2, 0.2);
                const double y = dice.between(-0.05, 0.05);
                step = Vec3(x, y, dice.between(-0.2, 0.2));
            }
            foot += step;
            around.cover({foot - Vec3(0.5, 0.3, 0.5), foot + Vec3(0.5, 2.1, 0.5)});
            std::set<PieceId> held;
            for (const ContactCache::Piece& piece : around.pieces()) {
                ASSERT_TRUE(held.emplace(piece.obstacle.object, piece.obstacle.triangle).second)
                    << "seed " << seed << ", step " << i;
            }
            std::vector<Obstacle> expected;
            gather_obstacles(*world, {}, body.core(foot), 0.5, expected);
            for (const Obstacle& o : expected) {
                const bool is_box = o.solid != nullptr && std::holds_alternative<Box>(o.solid->shape);
                ASSERT_TRUE(is_box || held.contains({o.object, o.triangle}))
                    << "seed " << seed << ", step " << i;
                ++held_in_total;
            }
        }
    }
    EXPECT_GT(held_in_total, support::repeats(1000));
}

/// The state and the trace that a tick leaves behind, compared bit for bit.
void expect_same(const MoverState& state, const MoveTrace& trace, const MoverState& other,
                 const MoveTrace& other_trace) {
    EXPECT_TRUE(state == other) << state.foot.transpose() << " and " << other.foot.transpose();
    EXPECT_EQ(trace.path, other_trace.path);
    EXPECT_EQ(trace.landed, other_trace.landed);
    EXPECT_EQ(trace.fall_height, other_trace.fall_height);
    ASSERT_EQ(trace.touching.size(), other_trace.touching.size());
    for (std::size_t i = 0; i < trace.touching.size(); ++i) {
        EXPECT_EQ(trace.touching[i].object, other_trace.touching[i].object);
        EXPECT_EQ(trace.touching[i].gap, other_trace.touching[i].gap);
    }
}

/// The same move with the cache of all earlier ticks, with a fresh one, and with one that a body of another
/// height uses in turn.
TEST(MoverCache, NeverChangesAMove) {
    int repeated = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(support::repeats(12)); ++seed) {
        Dice dice(seed);
        const auto world = seed % 2 == 0 ? support::make_soup(dice) : support::make_random_village(dice);
        const CapsuleMover mover(*world, {}, {});
        const CapsuleMover child(*world, {.height = 1.1}, {});
        MoverCache cache;
        MoverCache shared;
        MoverState state;
        state.foot = support::random_free_place(*world, dice, support::kSoupHalf);
        MoverState child_state = state;
        MoveTrace trace;
        MoveTrace other_trace;
        Vec3 desired = Vec3::Zero();
        for (int tick = 0; tick < 400; ++tick) {
            SCOPED_TRACE(testing::Message() << "seed " << seed << ", tick " << tick);
            if (tick % 25 == 0) {
                desired = 0.05 * Vec3(dice.between(-1, 1), 0, dice.between(-1, 1));
            }
            const MoverState start = state;
            mover.move(state, desired, 1.0 / 60.0, cache, trace);
            repeated += state == start ? 1 : 0;

            MoverState other = start;
            MoverCache fresh;
            mover.move(other, desired, 1.0 / 60.0, fresh, other_trace);
            ASSERT_NO_FATAL_FAILURE(expect_same(state, trace, other, other_trace));

            child.move(child_state, desired, 1.0 / 60.0, shared, other_trace);
            other = start;
            mover.move(other, desired, 1.0 / 60.0, shared, other_trace);
            ASSERT_NO_FATAL_FAILURE(expect_same(state, trace, other, other_trace));
            ASSERT_FALSE(testing::Test::HasFailure());
        }
    }
    EXPECT_GT(repeated, 0) << "some moves came to rest";
}

}  // namespace
}  // namespace campuswalk::collision
