#include "collision/world/overlap_span.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/plain_solids.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::add_object;
using support::Dice;
using support::Line;

constexpr double kBodyRadius = 0.3;

Segment placement_at(const Vec3& foot) {
    return {foot + Vec3(0, kBodyRadius, 0), foot + Vec3(0, 1.5, 0)};
}

std::optional<OverlapSpan> span_of(const World& world, ObjectId id, const Vec3& from, const Vec3& move) {
    return overlap_span(world, id, placement_at(from), kBodyRadius, move);
}

/// The interval where a convex function is negative, by bisection from both ends.
template <typename Gap>
std::optional<OverlapSpan> plain_span(const Gap& gap_at) {
    const auto enter = support::first_not_above_zero(gap_at);
    if (!enter) {
        return std::nullopt;
    }
    const auto leave = support::first_not_above_zero([&](double f) { return gap_at(1.0 - f); });
    return OverlapSpan{*enter, 1.0 - leave.value_or(1.0), gap_at(0.0) <= 0.0, gap_at(1.0) <= 0.0};
}

/// A grazing contact may be found by only one of the two, so near touches are not compared.
template <typename Gap>
bool clear_cut(const Gap& gap_at) {
    constexpr double kGraze = 1e-4;
    const double least = support::least_on_unit_interval(gap_at);
    return std::abs(least) > kGraze && std::abs(gap_at(0.0)) > kGraze && std::abs(gap_at(1.0)) > kGraze;
}

void expect_same(const std::optional<OverlapSpan>& ours, const std::optional<OverlapSpan>& plain) {
    ASSERT_EQ(ours.has_value(), plain.has_value());
    if (ours) {
        EXPECT_NEAR(ours->enter, plain->enter, 1e-5);
        EXPECT_NEAR(ours->leave, plain->leave, 1e-5);
        EXPECT_EQ(ours->at_start, plain->at_start);
        EXPECT_EQ(ours->at_end, plain->at_end);
    }
}

TEST(OverlapSpan, OfASolidAgreesWithThePlainDistance) {
    Dice dice(90);
    int spans = 0;
    const int moves = support::repeats(400);
    for (int i = 0; i < moves; ++i) {
        SCOPED_TRACE(i);
        World world(std::make_unique<LinearBroadPhase>());
        Object object;
        object.shape = support::random_solid(dice);
        object.X_world_shape = support::random_pose(dice, 0.5);
        const ObjectId id = world.add(object);
        const Vec3 from = dice.in_cube(2.0);
        const Vec3 move = dice.in_cube(2.0) - from;
        const Segment body = placement_at(from);
        const auto gap_at = [&](double f) {
            return support::signed_distance(object, Line{body.a + f * move, body.b + f * move}) - kBodyRadius;
        };
        if (!clear_cut(gap_at)) {
            continue;
        }
        const auto ours = span_of(world, id, from, move);
        expect_same(ours, plain_span(gap_at));
        spans += ours ? 1 : 0;
    }
    EXPECT_GT(spans, moves / 10);
}

TEST(OverlapSpan, OfATriangleAgreesWithThePlainDistance) {
    Dice dice(91);
    int spans = 0;
    const int moves = support::repeats(2000);
    for (int i = 0; i < moves; ++i) {
        SCOPED_TRACE(i);
        World world(std::make_unique<LinearBroadPhase>());
        TriangleMesh mesh;
        const Triangle t = support::random_triangle(dice, dice.in_cube(1.0));
        support::add_triangle(mesh, t.a, t.b, t.c);
        const support::Vertices rounded = support::vertices_of(vertices(mesh, 0));
        const ObjectId id = add_object(world, mesh);
        const Vec3 from = dice.in_cube(2.0);
        const Vec3 move = dice.in_cube(2.0) - from;
        const Segment body = placement_at(from);
        const auto gap_at = [&](double f) {
            return support::distance(Line{body.a + f * move, body.b + f * move}, rounded) - kBodyRadius;
        };
        if (!clear_cut(gap_at)) {
            continue;
        }
        const auto ours = span_of(world, id, from, move);
        expect_same(ours, plain_span(gap_at));
        spans += ours ? 1 : 0;
    }
    EXPECT_GT(spans, moves / 10);
}

TEST(OverlapSpan, CoversAPassThroughATriggerBoxInOneTick) {
    World world(std::make_unique<LinearBroadPhase>());
    const ObjectId id = add_object(world, Box{{0.5, 2, 0.5}}, {0, 0, 0});
    const auto span = span_of(world, id, {-5, 0, 0}, {10, 0, 0});
    ASSERT_TRUE(span);
    EXPECT_NEAR(span->enter, (5.0 - 0.8) / 10.0, 1e-9);
    EXPECT_NEAR(span->leave, (5.0 + 0.8) / 10.0, 1e-9);
    EXPECT_FALSE(span->at_start);
    EXPECT_FALSE(span->at_end);
    EXPECT_FALSE(span_of(world, id, {-5, 0, 2}, {10, 0, 0}));
    EXPECT_FALSE(span_of(world, id, {-5, 0, 0}, {4.1, 0, 0})) << "stops before it";
}

TEST(OverlapSpan, OfABodyAtRestIsTheWholeTick) {
    World world(std::make_unique<LinearBroadPhase>());
    const ObjectId id = add_object(world, Box{{0.5, 2, 0.5}}, {0, 0, 0});
    const auto span = span_of(world, id, {0.7, 0, 0}, {0, 0, 0});
    ASSERT_TRUE(span);
    EXPECT_TRUE(span->at_start);
    EXPECT_TRUE(span->at_end);
    EXPECT_EQ(span->enter, 0.0);
    EXPECT_EQ(span->leave, 1.0);
    EXPECT_FALSE(span_of(world, id, {0.9, 0, 0}, {0, 0, 0}));
}

TEST(OverlapSpan, IncludesTheInteriorOfAClosedMesh) {
    World world(std::make_unique<LinearBroadPhase>());
    TriangleMesh box;
    support::add_box(box, {-5, -5, -5}, {5, 5, 5});
    const ObjectId id = add_object(world, box);
    const auto still = span_of(world, id, {0, -1, 0}, {0.1, 0, 0});
    ASSERT_TRUE(still);
    EXPECT_TRUE(still->at_start);
    EXPECT_TRUE(still->at_end);
    const auto in = span_of(world, id, {-8, -1, 0}, {8, 0, 0});
    ASSERT_TRUE(in);
    EXPECT_NEAR(in->enter, 2.7 / 8.0, 1e-9);
    EXPECT_EQ(in->leave, 1.0);
    EXPECT_FALSE(in->at_start);
    EXPECT_TRUE(in->at_end);
    const auto out = span_of(world, id, {0, -1, 0}, {8, 0, 0});
    ASSERT_TRUE(out);
    EXPECT_EQ(out->enter, 0.0);
    EXPECT_NEAR(out->leave, 5.3 / 8.0, 1e-9);
    EXPECT_TRUE(out->at_start);
    EXPECT_FALSE(out->at_end);
}

TEST(OverlapSpan, IsEmptyBetweenTheWallsOfAnOpenRoom) {
    World world(std::make_unique<LinearBroadPhase>());
    TriangleMesh room;
    support::add_quad(room, {-5, -5, 5}, {5, -5, 5}, {5, 5, 5}, {-5, 5, 5});
    support::add_quad(room, {5, -5, -5}, {-5, -5, -5}, {-5, 5, -5}, {5, 5, -5});
    const ObjectId id = add_object(world, room);
    EXPECT_FALSE(span_of(world, id, {0, 0, 0}, {0, 0, 2}));
    const auto whole = span_of(world, id, {0, 0, -8}, {0, 0, 16});
    ASSERT_TRUE(whole) << "from the first contact to the last, whatever gap lies between";
    EXPECT_NEAR(whole->enter, 2.7 / 16.0, 1e-9);
    EXPECT_NEAR(whole->leave, 13.3 / 16.0, 1e-9);
}

}  // namespace
}  // namespace campuswalk::collision
