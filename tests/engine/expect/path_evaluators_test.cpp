#include "engine/expect/path_evaluators.h"

#include <gtest/gtest.h>

#include "tests/engine/expect/single_evaluator.h"
#include "tests/engine/short_walk.h"

namespace campuswalk::engine {
namespace {

using Eigen::Vector3d;

// ---- reaches --------------------------------------------------------------------------------------------

TEST(ReachesEvaluator, PassesWhenSomeTickEndedNearEnough) {
    const ExpectReaches expected = expect_reaches({"square", {3, 0, 4}, true}, 5.0, 11);
    OneEvaluator evaluator(expected);
    Frames(evaluator).tick({}, {100, 0, 0}).tick({}, {0, 0, 0}).tick({}, {-100, 0, 0});
    EXPECT_FALSE(evaluator.failure()) << "5 m away is within 5 m";
}

TEST(ReachesEvaluator, FailsWithTheNearest) {
    const ExpectReaches expected = expect_reaches({"square", {3, 0, 4}, true}, 1.0, 11);
    OneEvaluator evaluator(expected);
    Frames(evaluator).tick({}, {100, 0, 0}).tick({}, {0, 0, 0}).tick({}, {0, 0, 0}).tick({}, {-100, 0, 0});
    expect_failure(evaluator.failure(), 11, "reaches",
                   "square was not reached: the avatar came within 5.000 m at 0.100 s, expected 1.000 m");
}

TEST(ReachesEvaluator, CountsHeightOnlyWhenTheTargetHasOne) {
    const ExpectReaches with_height = expect_reaches({"roof", {0, 12, 0}, true}, 0.5, 11);
    const ExpectReaches without = expect_reaches({"0,0", {0, 0, 0}, false}, 0.5, 11);
    OneEvaluator strict(with_height);
    OneEvaluator lenient(without);
    Frames(strict).tick({}, {0, 8, 0});
    Frames(lenient).tick({}, {0, 8, 0});
    EXPECT_FALSE(lenient.failure());
    expect_failure(strict.failure(), 11, "reaches",
                   "roof was not reached: the avatar came within 4.000 m at 0.000 s, expected 0.500 m");
}

TEST(ReachesEvaluator, TellsOfTheNearestTick) {
    OneEvaluator evaluator(expect_reaches({"square", {3, 0, 4}, true}, 1.0, 11));
    Frames(evaluator).tick({}, {100, 0, 0}).tick({}, {0, 0, 0}).tick({}, {-100, 0, 0});
    EXPECT_EQ(evaluator.failure()->scene.tick, 1);
    EXPECT_EQ(evaluator.failure()->scene.position, Vector3d(0, 0, 0));
}

// ---- near -----------------------------------------------------------------------------------------------

ExpectNear near_bench(const std::optional<EventPattern>& at = std::nullopt) {
    return {{"a.walk.yaml", 14, 5}, {"bench", {3, 0, 4}, true}, 1.0, at};
}

TEST(NearEvaluator, LooksAtTheEnd) {
    OneEvaluator passes(near_bench());
    Frames(passes).tick({}, {100, 0, 0}).tick({}, {3, 0, 5});
    EXPECT_FALSE(passes.failure());
    OneEvaluator fails(near_bench());
    Frames(fails).tick({}, {3, 0, 4}).tick({}, {0, 0, 0});
    expect_failure(fails.failure(), 14, "near",
                   "the avatar was 5.000 m from bench at 0.100 s, expected within 1.000 m");
}

TEST(NearEvaluator, LooksAtEachEvent) {
    OneEvaluator evaluator(near_bench(pattern("avatar.stuck")));
    Frames frames(evaluator);
    frames.tick({"avatar.stuck me"}, {3, 0, 4}).tick({}, {50, 0, 0});
    EXPECT_FALSE(evaluator.failure()) << "where it is otherwise doesn't matter";
    frames.tick({"avatar.stuck me"}, {0, 0, 0}).tick({"avatar.stuck me"}, {9, 9, 9});
    expect_failure(
        evaluator.failure(), 14, "near",
        "the avatar was 5.000 m from bench at avatar.stuck me at 0.200 s, expected within 1.000 m");
}

TEST(NearEvaluator, KnowsWhereInTheTickAContactCame) {
    OneEvaluator evaluator(near_bench(pattern("trigger.enter door")));
    Frames(evaluator).with({made_event("trigger.enter door", {{"pos", Vector3d(3, 0, 4)}})}, {50, 0, 0});
    EXPECT_FALSE(evaluator.failure());
}

TEST(NearEvaluator, FailsWhenTheEventNeverCame) {
    ExpectNear expected = near_bench(pattern("avatar.stuck"));
    expected.at->mark = {"a.walk.yaml", 15, 9};
    OneEvaluator evaluator(expected);
    Frames(evaluator).tick({}, {3, 0, 4});
    expect_failure(evaluator.failure(), 15, "near", "'avatar.stuck' never came, so nothing was near bench");
}

// ---- duration and distance ------------------------------------------------------------------------------

std::optional<Failure> after_half_a_second(const Limits<double>& limits) {
    OneEvaluator evaluator(ExpectDuration{{"a.walk.yaml", 16, 5}, limits});
    Frames(evaluator).tick({}).tick({}).tick({}).tick({}).tick({}).tick({});
    return evaluator.failure();
}

TEST(DurationEvaluator, HoldsTheWalksTimeAgainstLimits) {
    EXPECT_FALSE(after_half_a_second({0.5, {}, {}}));
    EXPECT_FALSE(after_half_a_second({{}, 0.5, 0.5}));
    expect_failure(after_half_a_second({0.501, {}, {}}), 16, "duration",
                   "the walk took 0.500 s, expected exactly 0.501 s");
    expect_failure(after_half_a_second({{}, 0.6, {}}), 16, "duration",
                   "the walk took 0.500 s, expected at least 0.600 s");
    expect_failure(after_half_a_second({{}, {}, 0.4}), 16, "duration",
                   "the walk took 0.500 s, expected at most 0.400 s");
}

std::optional<Failure> after_twelve_metres(const Limits<double>& limits) {
    OneEvaluator evaluator(ExpectDistance{{"a.walk.yaml", 17, 5}, limits});
    Frames(evaluator).tick({}).after_metres(12.3454).tick({});
    return evaluator.failure();
}

TEST(DistanceEvaluator, HoldsTheWayAgainstLimits) {
    EXPECT_FALSE(after_twelve_metres({12.345, {}, {}})) << "as the log has it";
    EXPECT_FALSE(after_twelve_metres({{}, 12.3454, 12.3454}));
    expect_failure(after_twelve_metres({12.346, {}, {}}), 17, "distance",
                   "the avatar went 12.345 m, expected exactly 12.346 m");
    expect_failure(after_twelve_metres({{}, 20, {}}), 17, "distance",
                   "the avatar went 12.345 m, expected at least 20.000 m");
    expect_failure(after_twelve_metres({{}, {}, 12.0}), 17, "distance",
                   "the avatar went 12.345 m, expected at most 12.000 m");
}

}  // namespace
}  // namespace campuswalk::engine
