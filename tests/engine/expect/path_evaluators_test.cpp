#include "engine/expect/path_evaluators.h"

#include <gtest/gtest.h>

#include "tests/engine/expect/single_evaluator.h"
#include "tests/engine/short_walk.h"

namespace campuswalk::engine {
namespace {

using Eigen::Vector3d;

// ---- reaches --------------------------------------------------------------------------------------------

TEST(ReachesEvaluator, PassesIfAnyTickEndsNearEnough) {
    const ExpectReaches expected = expect_reaches({"square", {3, 0, 4}, true}, 5.0, 11);
    SingleEvaluator evaluator(expected);
    TickFeed(evaluator).tick({}, {100, 0, 0}).tick({}, {0, 0, 0}).tick({}, {-100, 0, 0});
    EXPECT_FALSE(evaluator.failure()) << "5 m away is within 5 m";
}

TEST(ReachesEvaluator, ReportsTheSmallestDistance) {
    const ExpectReaches expected = expect_reaches({"square", {3, 0, 4}, true}, 1.0, 11);
    SingleEvaluator evaluator(expected);
    TickFeed(evaluator).tick({}, {100, 0, 0}).tick({}, {0, 0, 0}).tick({}, {0, 0, 0}).tick({}, {-100, 0, 0});
    expect_failure(evaluator.failure(), 11, "reaches", {"square", "5.000 m", "0.100 s", "1.000 m"});
}

TEST(ReachesEvaluator, ComparesHeightsOnlyIfTheTargetHasOne) {
    const ExpectReaches with_height = expect_reaches({"roof", {0, 12, 0}, true}, 0.5, 11);
    const ExpectReaches without = expect_reaches({"0,0", {0, 0, 0}, false}, 0.5, 11);
    SingleEvaluator strict(with_height);
    SingleEvaluator lenient(without);
    TickFeed(strict).tick({}, {0, 8, 0});
    TickFeed(lenient).tick({}, {0, 8, 0});
    EXPECT_FALSE(lenient.failure());
    expect_failure(strict.failure(), 11, "reaches", {"roof", "4.000 m", "0.000 s", "0.500 m"});
}

TEST(ReachesEvaluator, ReportsTheSceneOfTheNearestTick) {
    SingleEvaluator evaluator(expect_reaches({"square", {3, 0, 4}, true}, 1.0, 11));
    TickFeed(evaluator).tick({}, {100, 0, 0}).tick({}, {0, 0, 0}).tick({}, {-100, 0, 0});
    EXPECT_EQ(evaluator.failure()->scene.tick, 1);
    EXPECT_EQ(evaluator.failure()->scene.position, Vector3d(0, 0, 0));
}

// ---- near -----------------------------------------------------------------------------------------------

ExpectNear near_bench(const std::optional<EventPattern>& at = std::nullopt) {
    return {{"a.walk.yaml", 14, 5}, {"bench", {3, 0, 4}, true}, 1.0, at};
}

TEST(NearEvaluator, ChecksTheEndOfTheWalkByDefault) {
    SingleEvaluator passes(near_bench());
    TickFeed(passes).tick({}, {100, 0, 0}).tick({}, {3, 0, 5});
    EXPECT_FALSE(passes.failure());
    SingleEvaluator fails(near_bench());
    TickFeed(fails).tick({}, {3, 0, 4}).tick({}, {0, 0, 0});
    expect_failure(fails.failure(), 14, "near", {"bench", "5.000 m", "0.100 s", "1.000 m"});
}

TEST(NearEvaluator, ChecksEachMatchingEvent) {
    SingleEvaluator evaluator(near_bench(pattern("avatar.stuck")));
    TickFeed feed(evaluator);
    feed.tick({"avatar.stuck me"}, {3, 0, 4}).tick({}, {50, 0, 0});
    EXPECT_FALSE(evaluator.failure()) << "other ticks don't matter";
    feed.tick({"avatar.stuck me"}, {0, 0, 0}).tick({"avatar.stuck me"}, {9, 9, 9});
    expect_failure(evaluator.failure(), 14, "near",
                   {"bench", "5.000 m", "avatar.stuck me at 0.200 s", "1.000 m"});
}

TEST(NearEvaluator, UsesThePositionOfAContactWithinTheTick) {
    SingleEvaluator evaluator(near_bench(pattern("trigger.enter door")));
    TickFeed(evaluator).with({made_event("trigger.enter door", {{"pos", Vector3d(3, 0, 4)}})}, {50, 0, 0});
    EXPECT_FALSE(evaluator.failure());
}

TEST(NearEvaluator, FailsIfTheEventIsMissing) {
    ExpectNear expected = near_bench(pattern("avatar.stuck"));
    expected.at->mark = {"a.walk.yaml", 15, 9};
    SingleEvaluator evaluator(expected);
    TickFeed(evaluator).tick({}, {3, 0, 4});
    expect_failure(evaluator.failure(), 15, "near", {"'avatar.stuck'", "bench"});
}

// ---- duration and distance ------------------------------------------------------------------------------

std::optional<Failure> after_half_a_second(const Limits<double>& limits) {
    SingleEvaluator evaluator(ExpectDuration{{"a.walk.yaml", 16, 5}, limits});
    TickFeed(evaluator).tick({}).tick({}).tick({}).tick({}).tick({}).tick({});
    return evaluator.failure();
}

TEST(DurationEvaluator, ComparesTheWalksTimeWithItsLimits) {
    EXPECT_FALSE(after_half_a_second({0.5, {}, {}}));
    EXPECT_FALSE(after_half_a_second({{}, 0.5, 0.5}));
    expect_failure(after_half_a_second({0.501, {}, {}}), 16, "duration", {"0.500 s", "exactly 0.501 s"});
    expect_failure(after_half_a_second({{}, 0.6, {}}), 16, "duration", {"0.500 s", "at least 0.600 s"});
    expect_failure(after_half_a_second({{}, {}, 0.4}), 16, "duration", {"0.500 s", "at most 0.400 s"});
}

std::optional<Failure> after_twelve_metres(const Limits<double>& limits) {
    SingleEvaluator evaluator(ExpectDistance{{"a.walk.yaml", 17, 5}, limits});
    TickFeed(evaluator).tick({}).after_metres(12.3454).tick({});
    return evaluator.failure();
}

TEST(DistanceEvaluator, ComparesTheDistanceWalkedWithItsLimits) {
    EXPECT_FALSE(after_twelve_metres({12.345, {}, {}})) << "rounded as in the log";
    EXPECT_FALSE(after_twelve_metres({{}, 12.3454, 12.3454}));
    expect_failure(after_twelve_metres({12.346, {}, {}}), 17, "distance", {"12.345 m", "exactly 12.346 m"});
    expect_failure(after_twelve_metres({{}, 20, {}}), 17, "distance", {"12.345 m", "at least 20.000 m"});
    expect_failure(after_twelve_metres({{}, {}, 12.0}), 17, "distance", {"12.345 m", "at most 12.000 m"});
}

}  // namespace
}  // namespace campuswalk::engine
