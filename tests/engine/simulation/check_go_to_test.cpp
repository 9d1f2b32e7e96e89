#include "engine/simulation/check_go_to.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

// Which steps go_to are known beforehand not to get to their places.

namespace campuswalk::engine {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Marked with that line.
GoToStep go_to_at_line(int line, double x, double z, double y = 0.0) {
    GoToStep step;
    step.mark = {"a.walk.yaml", line, 12};
    step.target = {"goal-" + std::to_string(line), {x, y, z}, true};
    return step;
}

/// A floor with a stage of 0.45 m in its north, and a gate in a wall across the south.
scene::Campus fenced_yard() {
    scene::Campus campus = level_campus(15.0);
    add_box(campus, "stage", {-15, -0.1, -14}, {15, 0.45, -5});
    add_box(campus, "wall/west", {-15, 0, 4.9}, {-1, 3, 5.1});
    add_box(campus, "wall/east", {1, 0, 4.9}, {15, 3, 5.1});
    add_box(campus, "gate", {-1, 0, 4.9}, {1, 3, 5.1});
    return campus;
}

std::vector<int> warned_lines(const Walk& walk) {
    std::vector<int> lines;
    for (const scene::Diagnostic& diagnostic : check_go_to(fenced_yard(), walk, nullptr)) {
        EXPECT_EQ(diagnostic.severity, scene::Severity::warning);
        EXPECT_EQ(diagnostic.code.text(), "unreachable-place");
        lines.push_back(diagnostic.mark.line);
    }
    return lines;
}

TEST(CheckGoTo, SaysWhyNotMeasured) {
    const auto found =
        check_go_to(fenced_yard(), walk_of({spawn_at({0, 0, 0}), go_to_at_line(7, 0, -8, 0.45)}), nullptr);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].mark, (scene::SourceMark{"a.walk.yaml", 7, 12}));
    EXPECT_THAT(found[0].message, HasSubstr("goal-7 can't be reached: riser of 0.45 m at stage"));
}

TEST(CheckGoTo, GoesOnFromTheLastPlaceOnTheGround) {
    EXPECT_THAT(
        warned_lines(walk_of({spawn_at({0, 0, 0}), go_to_at_line(1, 0, -8, 0.45), go_to_at_line(2, 3, 3),
                              go_to_at_line(3, 0, 9), go_to_at_line(4, -3, 3)})),
        ElementsAre(1, 3));
}

TEST(CheckGoTo, IsAskedFromWhereTheAvatarIsThen) {
    EXPECT_THAT(
        warned_lines(walk_of({spawn_at({0, 0, 0}), teleport_to({0, 0.45, -8}), go_to_at_line(1, 2, -8, 0.45),
                              walk_to(2, 0), go_to_at_line(2, 0, -8, 0.45)})),
        ElementsAre(2));
    EXPECT_THAT(warned_lines(walk_of({spawn_at({0, 0, 9}), go_to_at_line(1, 0, 8), go_to_at_line(2, 0, 0)})),
                ElementsAre(2));
    EXPECT_THAT(
        warned_lines(walk_of({spawn_at({0, 0, -4.5}), jump_up(4.0, 2.0), go_to_at_line(1, 0, -8, 0.45)})),
        IsEmpty())
        << "it jumped onto the stage";
}

TEST(CheckGoTo, HeedsWhatIsSwitchedByThen) {
    EXPECT_THAT(warned_lines(walk_of({spawn_at({0, 0, 9}), disable("gate"), go_to_at_line(1, 0, 0),
                                      enable("gate"), go_to_at_line(2, 0, 9)})),
                ElementsAre(2));
}

TEST(CheckGoTo, WarnsOncePerStepOfARepeat) {
    EXPECT_THAT(warned_lines(walk_of({spawn_at({0, 0, 0}), go_to_at_line(1, 0, 9), go_to_at_line(2, 3, 3),
                                      go_to_at_line(1, 0, 9), go_to_at_line(2, 3, 3)})),
                ElementsAre(1));
}

TEST(CheckGoTo, DoesNotGuessAfterAStepThatEndsTheWalk) {
    EXPECT_THAT(warned_lines(walk_of({spawn_at({0, 0, 0}), walk_to(0, -8), go_to_at_line(1, 0, 9)})),
                IsEmpty());
    WalkToStep may_fail = walk_to(0, -8);
    may_fail.if_blocked = IfBlocked::proceed;
    EXPECT_THAT(warned_lines(walk_of({spawn_at({0, 0, 0}), may_fail, go_to_at_line(1, 0, 9)})),
                ElementsAre(1));
}

TEST(CheckGoTo, IgnoresExpectationsAndWhatMustFail) {
    Walk walk =
        walk_of({spawn_at({0, 0, 0}), ExpectStep{{}, {expect_never("walk.start")}}, go_to_at_line(1, 0, 9)});
    walk.expectations = {expect_never("walk.start")};
    EXPECT_THAT(warned_lines(walk), ElementsAre(1)) << "after an expectation that fails";
    walk.status.kind = WalkStatus::Kind::xfail;
    EXPECT_THAT(warned_lines(walk), IsEmpty());
    walk.status.codes = {"never"};
    EXPECT_THAT(warned_lines(walk), ElementsAre(1));
    walk.status.codes.push_back("unreachable");
    EXPECT_THAT(warned_lines(walk), IsEmpty());
    walk.status = {};
    walk.status.kind = WalkStatus::Kind::skip;
    EXPECT_THAT(warned_lines(walk), IsEmpty()) << "nobody walks it";
}

TEST(CheckGoTo, PlaysNothingAfterTheLastOne) {
    // Standing still for a hundred million ticks would take a minute.
    EXPECT_THAT(warned_lines(walk_of({spawn_at({0, 0, 0}), go_to_at_line(1, 3, 3), wait_for(1e6)})),
                IsEmpty());
    EXPECT_THAT(warned_lines(walk_of({spawn_at({0, 0, 0}), wait_for(1e6)})), IsEmpty());
}

}  // namespace
}  // namespace campuswalk::engine
