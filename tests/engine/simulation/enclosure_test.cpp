#include "engine/simulation/enclosure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

// Why an avatar has no room: what is too low or too narrow, by how much, and where there is room.

namespace campuswalk::engine {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

/// The failure of a walk to the origin, around which `object` is switched on.
Failure enclosed(const scene::Campus& campus, const std::string& object) {
    const RecordedRun result =
        run(campus, walk_of({spawn_at({9, 0, 0}), disable(object), walk_to(0, 0), enable(object)}));
    EXPECT_EQ(result.summary.failures.size(), 1U);
    return result.summary.failures.empty() ? Failure() : result.summary.failures[0];
}

TEST(Enclosure, TellsHowMuchHeadroomIsLeft) {
    scene::Campus campus = level_campus();
    add_box(campus, "roof", {-3, 1.2, -3}, {3, 4, 3});
    const Failure failure = enclosed(campus, "roof");
    EXPECT_EQ(failure.code, "enclosed");
    EXPECT_THAT(failure.message, HasSubstr("headroom of 1.20 m under roof, 0."));
    EXPECT_THAT(failure.message, HasSubstr("the body needs 1.80 m"));
    ASSERT_TRUE(failure.scene.contact.has_value());
    EXPECT_NEAR(failure.scene.contact->y(), 1.2, 0.01) << "the picture is aimed at the roof";
}

TEST(Enclosure, TellsHowWideTheRoomIs) {
    scene::Campus campus = level_campus();
    // A shaft of 0.4 m by 0.4 m, deeper than anything that the body could be pushed out of.
    add_box(campus, "shaft/west", {-3, 0, -3}, {-0.2, 4, 3});
    add_box(campus, "shaft/east", {0.2, 0, -3}, {3, 4, 3});
    add_box(campus, "shaft/north", {-0.2, 0, -3}, {0.2, 4, -0.2});
    add_box(campus, "shaft/south", {-0.2, 0, 0.2}, {0.2, 4, 3});
    EXPECT_THAT(enclosed(campus, "shaft/*").message,
                MatchesRegex(".*the opening at shaft/.* is 0\\.40 m wide, the body needs 0\\.60 m.*"));
}

TEST(Enclosure, TellsWhereTheNearestRoomIs) {
    scene::Campus campus = level_campus();
    add_box(campus, "block", {-3, -1, -2}, {3, 4, 3});
    // Northwards, on the other side of the block's wall at z = -2: 2 m and the radius of the body.
    EXPECT_THAT(
        enclosed(campus, "block").message,
        MatchesRegex("block encloses the avatar; the nearest room is 2\\.[34][0-9] m away at "
                     "-?0\\.[0-9]+, -?0\\.0[0-9], -2\\.[34][0-9]; move the avatar away before 'enable'"));
}

TEST(Enclosure, TellsIfThereIsNoRoomNearby) {
    scene::Campus campus = level_campus();
    add_box(campus, "block", {-20, -1, -20}, {20, 4, 20});
    const RecordedRun result =
        run(campus, walk_of({spawn_at({22, 0, 0}), disable("block"), walk_to(0, 0), enable("block")}));
    EXPECT_THAT(result.summary.failures.at(0).message, HasSubstr("there is no room within 10 m"));
}

TEST(Enclosure, TellsWhyTheAvatarCannotStandUp) {
    scene::Campus campus = level_campus();
    add_box(campus, "beam", {-3, 1.5, -6}, {3, 2, -2});
    const RecordedRun result =
        run(campus, walk_of({spawn_at({0, 0, 0}), set_height(1.2), walk_to(0, -4), set_height(1.8)}));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    EXPECT_THAT(result.summary.failures[0].message,
                MatchesRegex("there is no headroom for 1\\.80 m: headroom of 1\\.50 m under beam, .*; the "
                             "body needs 1\\.80 m"));
}

}  // namespace
}  // namespace campuswalk::engine
