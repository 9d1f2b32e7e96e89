#include "tools/campuswalk_bench/explore/explore_verdicts.h"

#include <gtest/gtest.h>

namespace campuswalk::tools::bench {
namespace {

ExploreScore score_of(double ours, double peer, double bytes) {
    ExploreScore score;
    score.times = {{"ours", 1, ours, ours, ours}, {"recast", 1, peer, peer, peer}};
    score.bytes_per_area = bytes;
    score.adversary.walks = 1000;
    return score;
}

TEST(ExploreVerdicts, CompareScoresWithTargets) {
    const std::vector<Verdict> verdicts = explore_verdicts({score_of(8, 1, 100), score_of(1, 2, 390)});
    ASSERT_EQ(verdicts.size(), 13U);
    EXPECT_DOUBLE_EQ(verdicts[0].value.value(), 2.0) << "the geometric mean of 8 and 0.5";
    EXPECT_TRUE(verdicts[0].holds);
    EXPECT_FALSE(verdicts[1].value) << "two threads weren't measured";
    EXPECT_FALSE(verdicts[1].holds);
    EXPECT_DOUBLE_EQ(verdicts[4].value.value(), 390.0) << "the worst campus";
    EXPECT_TRUE(verdicts[4].holds);
    EXPECT_DOUBLE_EQ(verdicts[5].value.value(), 0.0);
    EXPECT_TRUE(verdicts[5].holds);
    EXPECT_FALSE(verdicts[6].value) << "no walk steered";
}

TEST(ExploreVerdicts, LeaveReachOutOfAReportsTime) {
    ExploreScore score = score_of(2, 1, 1);
    EXPECT_FALSE(explore_verdicts({score})[2].value) << "no report was measured";
    score.times.push_back({"report", 1, 7, 7, 7});
    EXPECT_DOUBLE_EQ(explore_verdicts({score})[2].value.value(), 2.5) << "(7 - 2) / 2";
}

TEST(ExploreVerdicts, CountWalksThatGotOutside) {
    ExploreScore score = score_of(1, 1, 1);
    EXPECT_TRUE(is_correct(score));
    score.adversary.escapes.resize(1);
    EXPECT_FALSE(is_correct(score));
    const std::vector<Verdict> verdicts = explore_verdicts({score});
    EXPECT_DOUBLE_EQ(verdicts[5].value.value(), 10.0) << "of 10,000";
    EXPECT_FALSE(verdicts[5].holds);
}

TEST(ExploreVerdicts, CompareRoutesWithThePeers) {
    ExploreScore one = score_of(1, 1, 1);
    RouteScore& routes = one.routes.emplace();
    routes.pairs = routes.joined = routes.found = 100;
    routes.length_ratio = 0.9;
    routes.ours = {80.0, 600.0};
    routes.again = {5.0, 40.0};
    routes.peer = QueryTimes{10.0, 20.0};
    ExploreScore other = one;
    other.routes->ours.median = 20.0;
    EXPECT_TRUE(is_correct(one));
    const std::vector<Verdict> verdicts = explore_verdicts({one, other, score_of(1, 1, 1)});
    EXPECT_DOUBLE_EQ(verdicts[7].value.value(), 100.0);
    EXPECT_TRUE(verdicts[7].holds);
    EXPECT_NEAR(verdicts[8].value.value(), 0.9, 1e-12);
    EXPECT_NEAR(verdicts[9].value.value(), 4.0, 1e-12) << "the geometric mean of 8 and 2";
    EXPECT_NEAR(verdicts[10].value.value(), 30.0, 1e-12);
    EXPECT_NEAR(verdicts[11].value.value(), 0.5, 1e-12);
    EXPECT_NEAR(verdicts[12].value.value(), 2.0, 1e-12);

    other.routes->found = 99;
    EXPECT_FALSE(is_correct(other));
    EXPECT_FALSE(explore_verdicts({other})[7].holds);
    one.routes->blocked = 1;
    EXPECT_FALSE(is_correct(one));
    one.routes->blocked = 0;
    EXPECT_TRUE(is_correct(one));
    one.routes->changed = 1;
    EXPECT_FALSE(is_correct(one));
}

TEST(ExploreVerdicts, WantTheSameForAnyNumberOfThreads) {
    ExploreScore score = score_of(1, 1, 1);
    score.is_same_by_threads = false;
    EXPECT_FALSE(is_correct(score));
}

}  // namespace
}  // namespace campuswalk::tools::bench
