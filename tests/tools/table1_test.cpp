#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/campuswalk_bench/pairs/cost_model.h"
#include "tools/campuswalk_bench/pairs/pair_runs.h"

namespace campuswalk::tools::bench {
namespace {

using collision::HybridContactStatistics;
using collision::Pose;
using collision::QueryStatistics;
using collision::TrianglePair;
using Pairs = std::vector<TrianglePair>;

/// Always returns the same pairs, in every placement.
class CannedEngine final : public Engine {
public:
    CannedEngine(Pairs pairs, bool stops) : pairs_(std::move(pairs)), stops_(stops) {}

    void set_pose(const Pose& /*X_a_b*/) override { ++moves; }
    void all_pairs(Pairs& out) override {
        ++alls;
        out = pairs_;
    }
    bool stops_at_first() const override { return stops_; }
    std::optional<TrianglePair> first_pair() override {
        ++firsts;
        return pairs_.empty() ? std::nullopt : std::optional(pairs_.front());
    }
    std::optional<HybridContactStatistics> work() const override { return std::nullopt; }

    int moves = 0;
    int alls = 0;
    int firsts = 0;

private:
    Pairs pairs_;
    bool stops_ = true;
};

PairScene two_placements() {
    PairScene scene;
    scene.name = "canned";
    scene.placements = {{{}, 3}, {{}, std::nullopt}};
    return scene;
}

CannedEngine& add(std::vector<NamedEngine>& engines, const char* name, Pairs pairs, bool stops = true,
                  bool is_ours = false) {
    auto engine = std::make_unique<CannedEngine>(std::move(pairs), stops);
    CannedEngine& added = *engine;
    engines.push_back({name, is_ours, std::move(engine)});
    return added;
}

TEST(PairRuns, CompareSetsIgnoringOrderAndRepeats) {
    std::vector<NamedEngine> engines;
    add(engines, "right", {{1, 1}, {2, 2}, {3, 3}});
    add(engines, "repeats", {{3, 3}, {1, 1}, {3, 3}, {2, 2}, {1, 1}});
    add(engines, "lacks two, invents one", {{4, 4}, {2, 2}});
    add(engines, "finds nothing", {});
    const Results results = measure(two_placements(), engines, 2);
    EXPECT_EQ(results.found, (std::vector<std::size_t>{3, 3}));
    EXPECT_EQ(results.pairs, (std::vector<std::size_t>{3, 3}))
        << "what was found where the number is unknown";
    const auto all = [&](const char* name) { return results.find(1, name, Query::all)->difference; };
    const auto first = [&](const char* name) { return results.find(1, name, Query::first)->difference; };
    EXPECT_TRUE(all("right").none());
    EXPECT_TRUE(all("repeats").none());
    EXPECT_EQ(to_string(all("lacks two, invents one")), "+1/-2");
    EXPECT_EQ(to_string(all("finds nothing")), "+0/-3");
    EXPECT_TRUE(first("right").none());
    EXPECT_TRUE(first("repeats").none());
    EXPECT_EQ(to_string(first("lacks two, invents one")), "+1/-0");
    EXPECT_EQ(to_string(first("finds nothing")), "+0/-1");
}

TEST(PairRuns, EveryTimedRunFollowsAnUntimedOne) {
    std::vector<NamedEngine> engines;
    const CannedEngine& stops = add(engines, "stops", {{1, 1}});
    const CannedEngine& goes_on = add(engines, "goes on", {{1, 1}}, false);
    const Results results = measure(two_placements(), engines, 7);
    EXPECT_EQ(stops.alls, 2 * 2 * 7);
    EXPECT_EQ(stops.firsts, 2 * 2 * 7);
    EXPECT_EQ(stops.moves, stops.alls + stops.firsts) << "each query includes its move";
    EXPECT_EQ(goes_on.alls, 2 * 2 * 7);
    EXPECT_EQ(goes_on.firsts, 0);
    EXPECT_EQ(results.measurements.size(), 2U * 3U);
    EXPECT_EQ(results.find(0, "goes on", Query::first), nullptr);
    EXPECT_TRUE(results.least_times("goes on", Query::first).empty());
    for (const Measurement& m : results.measurements) {
        EXPECT_GE(m.us_median, m.us_min);
        EXPECT_GE(m.us_min, 0.0);
    }
}

TEST(PairRuns, MakeARowPerMeasurement) {
    std::vector<NamedEngine> engines;
    add(engines, "right", {{1, 1}, {2, 2}, {3, 3}});
    add(engines, "wrong", {{1, 1}}, false);
    const std::vector<Row> rows = rows_of(measure(two_placements(), engines, 1));
    ASSERT_EQ(rows.size(), 2U * 3U);
    EXPECT_EQ(rows[1].case_name, "canned");
    EXPECT_EQ(rows[1].engine, "right");
    EXPECT_EQ(rows[1].query, "first");
    EXPECT_EQ(rows[2].engine, "wrong");
    EXPECT_EQ(rows[2].query, "all");
    EXPECT_EQ(rows[2].pairs, 3U);
    EXPECT_EQ(rows[2].difference, (Difference{0, 2}));
    EXPECT_FALSE(rows[2].work.has_value());
}

/// What is printed about the engines, and whether any of ours is wrong.
std::string reported_errors(const std::vector<NamedEngine>& engines, bool& any) {
    const PairScene scene = two_placements();
    const Results results = measure(scene, engines, 1);
    testing::internal::CaptureStderr();
    any = report_our_errors(scene, results);
    return testing::internal::GetCapturedStderr();
}

TEST(PairRuns, ReportErrorsOfOurEnginesOnly) {
    bool any = true;
    std::vector<NamedEngine> engines;
    add(engines, "ours", {{1, 1}, {2, 2}, {3, 3}}, true, true);
    add(engines, "a peer", {{1, 1}});
    EXPECT_EQ(reported_errors(engines, any), "");
    EXPECT_FALSE(any);
    add(engines, "ours too", {{1, 1}}, false, true);
    EXPECT_THAT(reported_errors(engines, any),
                testing::MatchesRegex("error: canned: [^\n]*ours too [^\n]*\\+0/-2\n"
                                      "error: canned: [^\n]*ours too [^\n]*\\+0/-2\n"));
    EXPECT_TRUE(any);
}

TEST(PairRuns, ReportNumbersThatDifferFromTheScene) {
    bool any = false;
    std::vector<NamedEngine> engines;
    add(engines, "ours", {{1, 1}}, true, true);
    EXPECT_THAT(reported_errors(engines, any),
                testing::MatchesRegex("error: canned: ours [^\n]*1 [^\n]*3\n"));
    EXPECT_TRUE(any);
}

TEST(CostModel, RecoversTheCostsBehindTheTimes) {
    const std::vector<QueryStatistics> work = {
        {100, 7, 50}, {900, 120, 300}, {5000, 400, 2600}, {7000, 2, 10}};
    const CostModel made{0.02, 0.3, 0.005};
    std::vector<double> times;
    times.reserve(work.size());
    for (const QueryStatistics& w : work) {
        times.push_back(made.predict(w));
    }
    EXPECT_DOUBLE_EQ(times[0], 2.0 + 2.1 + 0.25);
    const CostModel found = fit_costs(work, times);
    EXPECT_NEAR(found.cv, made.cv, 1e-12);
    EXPECT_NEAR(found.cp, made.cp, 1e-12);
    EXPECT_NEAR(found.cu, made.cu, 1e-12);
}

TEST(CostModel, FitsNoNegativeCosts) {
    // Only a negative Cp would explain these times exactly.
    const std::vector<QueryStatistics> work = {{100, 0, 10}, {100, 50, 10}, {200, 10, 90}};
    const std::vector<double> times = {10.0, 5.0, 21.0};
    const CostModel found = fit_costs(work, times);
    EXPECT_EQ(found.cp, 0.0);
    EXPECT_GT(found.cv, 0.0);
    EXPECT_GE(found.cu, 0.0);
}

TEST(CostModel, MinimizesRelativeErrors) {
    // One cost can't explain both times; their relative errors have equal weight.
    const std::vector<QueryStatistics> work = {{100, 0, 0}, {100000, 0, 0}};
    const std::vector<double> times = {2.0, 1000.0};
    const double cv = fit_costs(work, times).cv;
    EXPECT_NEAR(cv, (50.0 + 100.0) / (2500.0 + 10000.0), 1e-12);
}

}  // namespace
}  // namespace campuswalk::tools::bench
