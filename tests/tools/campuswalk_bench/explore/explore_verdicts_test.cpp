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
    ASSERT_EQ(verdicts.size(), 5U);
    EXPECT_DOUBLE_EQ(verdicts[0].value.value(), 2.0) << "the geometric mean of 8 and 0.5";
    EXPECT_TRUE(verdicts[0].holds);
    EXPECT_FALSE(verdicts[1].value) << "two threads weren't measured";
    EXPECT_FALSE(verdicts[1].holds);
    EXPECT_DOUBLE_EQ(verdicts[2].value.value(), 390.0) << "the worst campus";
    EXPECT_TRUE(verdicts[2].holds);
    EXPECT_DOUBLE_EQ(verdicts[3].value.value(), 0.0);
    EXPECT_TRUE(verdicts[3].holds);
    EXPECT_FALSE(verdicts[4].value) << "no walk steered";
}

TEST(ExploreVerdicts, CountWalksThatGotOutside) {
    ExploreScore score = score_of(1, 1, 1);
    EXPECT_TRUE(is_correct(score));
    score.adversary.escapes.resize(1);
    EXPECT_FALSE(is_correct(score));
    const std::vector<Verdict> verdicts = explore_verdicts({score});
    EXPECT_DOUBLE_EQ(verdicts[3].value.value(), 10.0) << "of 10,000";
    EXPECT_FALSE(verdicts[3].holds);
}

TEST(ExploreVerdicts, WantTheSameForAnyNumberOfThreads) {
    ExploreScore score = score_of(1, 1, 1);
    score.is_same_by_threads = false;
    EXPECT_FALSE(is_correct(score));
}

}  // namespace
}  // namespace campuswalk::tools::bench
