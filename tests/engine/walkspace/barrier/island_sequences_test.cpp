// Ground behind other ground that isn't reached either: what one comes upon on the way, in that order. The
// numbers are those that the campuses were built with.

#include "engine/walkspace/barrier/island_sequences.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "collision/mesh/mesh_collider.h"
#include "tests/engine/small_campus.h"
#include "tests/engine/walkspace/barrier/explored_barrier.h"
#include "tests/engine/walkspace/explore/explored_ground.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine {
namespace {

using collision::Vec3;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kDegreesInRadian = 180.0 / std::numbers::pi;

/// North of z = -4, terraces of 8 m x 4 m one behind the other, each so much higher than the one before.
scene::Campus terraces(const std::vector<double>& risers) {
    scene::Campus campus = level_campus(30.0);
    const double north = -4.0 - 4.0 * static_cast<double>(risers.size());
    double height = 0.0;
    for (std::size_t i = 0; i < risers.size(); ++i) {
        height += risers[i];
        add_box(campus, "terrace-" + std::to_string(i + 1), {-4, 0, north},
                {4, height, -4.0 - 4.0 * static_cast<double>(i)});
    }
    return campus;
}

Vec3 on_last_of(const std::vector<double>& risers) {
    double height = 0.0;
    for (const double riser : risers) {
        height += riser;
    }
    return {0.0, height, -2.0 - 4.0 * static_cast<double>(risers.size())};
}

/// Of a sequence of risers, each of which begins where the one before ends.
std::vector<double> heights_of_parts(const Barrier& barrier) {
    EXPECT_EQ(barrier.kind, ReasonKind::sequence);
    std::vector<double> heights;
    double height = 0.0;
    for (const Barrier& part : barrier.parts) {
        EXPECT_EQ(part.kind, ReasonKind::riser);
        EXPECT_NEAR(part.at.y(), height + part.measured, 0.5 * part.measured);
        height += part.measured;
        heights.push_back(std::round(part.measured * 100.0) / 100.0);
    }
    return heights;
}

/// The upper one is too high for a step from the ground, and its risers are of different heights.
TEST(IslandSequences, EachRiserOfTerracesIsNamedWithItsHeight) {
    const std::vector<double> risers{0.45, 0.5};
    scene::Campus campus = terraces(risers);
    const Vec3 place = on_last_of(risers);
    EXPECT_THAT(heights_of_parts(barrier_of_ground(campus, place)), ElementsAre(0.45, 0.5));
    EXPECT_THAT(heights_of_parts(explored_barrier(campus, place)), ElementsAre(0.45, 0.5));
    EXPECT_THAT(reason_to_go(campus, place), HasSubstr("riser of 0.45 m at terrace-1"));
    EXPECT_THAT(reason_to_go(campus, place), HasSubstr(", then riser of 0.50 m at terrace-2"));
}

/// A hall of four rooms, the doors between which are closed. Its walls are of one mesh with the ground.
scene::Campus closed_rooms() {
    collision::TriangleMesh mesh;
    support::add_quad(mesh, {-30, 0, 30}, {30, 0, 30}, {30, 0, -30}, {-30, 0, -30});
    support::add_box(mesh, {-16, 0, -3.2}, {0, 4, -3});
    support::add_box(mesh, {-16, 0, 3}, {0, 4, 3.2});
    support::add_box(mesh, {-16.2, 0, -3.2}, {-16, 4, 3.2});
    for (const double x : {0.0, -4.0, -8.0, -12.0}) {
        support::add_box(mesh, {x - 0.1, 0, -3}, {x + 0.1, 4, -0.5});
        support::add_box(mesh, {x - 0.1, 0, 0.5}, {x + 0.1, 4, 3});
    }
    scene::Campus campus = campus_of(std::move(mesh));
    for (int i = 0; i < 4; ++i) {
        const double x = -4.0 * i;
        add_box(campus, "door-" + std::to_string(i + 1), {x - 0.05, 0, -0.5}, {x + 0.05, 4, 0.5});
    }
    return campus;
}

TEST(IslandSequences, DoorsOneBehindTheOther) {
    scene::Campus campus = closed_rooms();
    const Vec3 place(-14.0, 0.0, 0.0);
    const Barrier barrier = explored_barrier(campus, place);
    ASSERT_EQ(barrier.kind, ReasonKind::sequence);
    std::vector<std::string> doors;
    for (const Barrier& part : barrier.parts) {
        EXPECT_EQ(part.kind, ReasonKind::object);
        doors.push_back(campus.objects[index_of(*part.object)].id);
    }
    EXPECT_THAT(doors, ElementsAre("door-1", "door-2", "door-3", "door-4"));
    EXPECT_THAT(reason_to_go(campus, place), HasSubstr("; then door-4 stands in the way"));
}

TEST(IslandSequences, ALedgeMayBeTheLast) {
    const std::vector<double> risers{0.45, 0.9};
    scene::Campus campus = terraces(risers);
    const Vec3 place = on_last_of(risers);
    const Barrier barrier = explored_barrier(campus, place);
    ASSERT_EQ(barrier.kind, ReasonKind::sequence);
    ASSERT_EQ(barrier.parts.size(), 2);
    EXPECT_EQ(barrier.parts[0].kind, ReasonKind::riser);
    EXPECT_NEAR(barrier.parts[0].measured, 0.45, 0.01);
    EXPECT_EQ(barrier.parts[1].kind, ReasonKind::ledge);
    EXPECT_NEAR(barrier.parts[1].measured, 0.9, 0.01);
    EXPECT_THAT(reason_to_go(campus, place), HasSubstr("; then ledge of 0.90 m at terrace-2"));
}

TEST(IslandSequences, ThreeInARow) {
    const std::vector<double> risers{0.4, 0.45, 0.5};
    scene::Campus campus = terraces(risers);
    const Vec3 place = on_last_of(risers);
    EXPECT_THAT(heights_of_parts(barrier_of_ground(campus, place)), ElementsAre(0.4, 0.45, 0.5));
    EXPECT_THAT(heights_of_parts(explored_barrier(campus, place)), ElementsAre(0.4, 0.45, 0.5));
    EXPECT_THAT(reason_to_go(campus, place), HasSubstr("then riser of 0.50 m at terrace-3"));
}

TEST(IslandSequences, TheFirstTerraceHasItsRiserOnly) {
    const scene::Campus campus = terraces({0.45, 0.5});
    const Barrier barrier = barrier_of_ground(campus, {0, 0.45, -6});
    EXPECT_EQ(barrier.kind, ReasonKind::riser);
    EXPECT_NEAR(barrier.measured, 0.45, 0.01);
}

TEST(IslandSequences, AreTheSameForAnyNumberOfWorkers) {
    const std::vector<double> risers{0.4, 0.45, 0.5};
    const scene::Campus campus = terraces(risers);
    const Barrier one = barrier_of_ground(campus, on_last_of(risers), 1);
    const Barrier three = barrier_of_ground(campus, on_last_of(risers), 3);
    ASSERT_EQ(one.parts.size(), three.parts.size());
    for (std::size_t i = 0; i < one.parts.size(); ++i) {
        EXPECT_EQ(one.parts[i].measured, three.parts[i].measured);
        EXPECT_EQ(one.parts[i].at, three.parts[i].at);
    }
}

/// A block of 1.5 m with a ramp of 52 degrees up to it, and a wall across it with a gap of 0.55 m.
scene::Campus ramp_and_gap() {
    scene::Campus campus = level_campus(30.0);
    const double height = 1.5;
    const double length = height / std::tan(52.0 / kDegreesInRadian);
    collision::TriangleMesh ramp;
    support::add_quad(ramp, {-1, 0, 0}, {1, 0, 0}, {1, height, -length}, {-1, height, -length});
    support::add_triangle(ramp, {-1, 0, 0}, {-1, height, -length}, {-1, 0, -length});
    support::add_triangle(ramp, {1, 0, 0}, {1, 0, -length}, {1, height, -length});
    add_object(campus, "ramp", std::make_shared<const collision::MeshCollider>(std::move(ramp)),
               Vec3::Zero());
    add_box(campus, "block", {-3, 0, -length - 12}, {3, height, -length});
    const double wall = -length - 6.0;
    add_box(campus, "west", {-3, height, wall - 0.2}, {-0.275, height + 4, wall});
    add_box(campus, "east", {0.275, height, wall - 0.2}, {3, height + 4, wall});
    return campus;
}

TEST(IslandSequences, ASteepRampAndThenANarrowOpening) {
    scene::Campus campus = ramp_and_gap();
    const Vec3 place(0, 1.5, -11);
    for (const Barrier& barrier : {barrier_of_ground(campus, place), explored_barrier(campus, place)}) {
        ASSERT_EQ(barrier.kind, ReasonKind::sequence);
        ASSERT_EQ(barrier.parts.size(), 2U);
        EXPECT_EQ(barrier.parts[0].kind, ReasonKind::slope);
        EXPECT_NEAR(barrier.parts[0].measured * kDegreesInRadian, 52.0, 0.5);
        EXPECT_EQ(barrier.parts[1].kind, ReasonKind::opening);
        EXPECT_NEAR(barrier.parts[1].measured, 0.55, 0.01);
        EXPECT_EQ(barrier.at, barrier.parts[0].at);
    }
    EXPECT_THAT(reason_to_go(campus, place), HasSubstr("slope of 52.0 degrees at ramp"));
    EXPECT_THAT(reason_to_go(campus, place), HasSubstr("; then west stands in the way"));
}

/// All one mesh, so that no object can be taken away: open ground and walls about a yard, from which on the
/// south side there is a terrace of 6 m outwards, or there isn't.
scene::Campus yard_in_one_mesh(bool has_terrace) {
    scene::Campus campus = empty_campus();
    collision::TriangleMesh mesh;
    support::add_quad(mesh, {-20, 0, 20}, {20, 0, 20}, {20, 0, -30}, {-20, 0, -30});
    support::add_box(mesh, {-6, 0, -20.2}, {6, 6, -20});
    support::add_box(mesh, {-6.2, 0, -20}, {-6, 6, -4});
    support::add_box(mesh, {6, 0, -20}, {6.2, 6, -4});
    if (has_terrace) {
        support::add_box(mesh, {-6, 0, -10}, {6, 0.45, -4});
    } else {
        support::add_box(mesh, {-6, 0, -4.2}, {6, 6, -4});
        support::add_box(mesh, {-6, 0, -20}, {6, 0.45, -12});
    }
    add_object(campus, "yard", std::make_shared<const collision::MeshCollider>(std::move(mesh)),
               Vec3::Zero());
    return campus;
}

/// Down from the terrace nothing more is in the way.
TEST(IslandSequences, WhereOneGetsAsOneIsNothingIsAdded) {
    scene::Campus campus = yard_in_one_mesh(true);
    const Vec3 place(0, 0, -15);
    for (const Barrier& barrier : {barrier_of_ground(campus, place), explored_barrier(campus, place)}) {
        EXPECT_EQ(barrier.kind, ReasonKind::riser);
        EXPECT_NEAR(barrier.measured, 0.45, 0.01);
        EXPECT_NEAR(barrier.at.z(), -4.0, 0.1);
    }
}

/// A terrace inside doesn't make it less closed.
TEST(IslandSequences, WhatIsInAClosedRoomStaysClosedOff) {
    const scene::Campus campus = yard_in_one_mesh(false);
    EXPECT_EQ(barrier_of_ground(campus, {0, 0, -8}).kind, ReasonKind::solid);
    EXPECT_EQ(barrier_of_ground(campus, {0, 0.45, -16}).kind, ReasonKind::solid);
}

/// Higher than anybody climbs from the terrace beside it.
TEST(IslandSequences, ARoofBesideATerraceStaysARoof) {
    scene::Campus campus = terraces({0.45});
    add_box(campus, "house", {-4, 0, -16}, {4, 4.0, -8});
    EXPECT_NE(barrier_of_ground(campus, {0, 4.0, -12}).kind, ReasonKind::sequence);
}

}  // namespace
}  // namespace campuswalk::engine
