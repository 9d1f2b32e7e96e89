// How `campuswalk-bench walk` scores made-up walkers, and ours on a small campus.

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>

#include "tests/collision/allocation_count.h"
#include "tests/support/dice.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/penetration_oracle.h"
#include "tests/support/temporary_folder.h"
#include "tools/campuswalk_bench/measure/heap.h"
#include "tools/campuswalk_bench/procedural/walkable_campus.h"
#include "tools/campuswalk_bench/walk/our_walker.h"
#include "tools/campuswalk_bench/walk/walk_csv.h"
#include "tools/campuswalk_bench/walk/walk_paths.h"
#include "tools/campuswalk_bench/walk/walk_run.h"
#include "tools/campuswalk_bench/walk/walk_score.h"
#include "tools/campuswalk_bench/walk/walk_verdicts.h"

namespace campuswalk::tools::bench {
namespace {

using collision::TriangleMesh;
using collision::Vec3;

/// Moves by a given function.
class MadeUpWalker final : public WalkEngine {
public:
    using Move = std::function<Vec3(const Vec3& foot, const Vec3& desired)>;
    explicit MadeUpWalker(Move move) : move_(std::move(move)) {}

    void place(const Vec3& foot) override { foot_ = foot; }
    void walk(const Vec3& desired) override { foot_ = move_(foot_, desired); }
    Vec3 foot() const override { return foot_; }

private:
    Move move_;
    Vec3 foot_ = Vec3::Zero();
};

/// A floor with a wall across it at x = 2.
TriangleMesh floor_and_wall() {
    TriangleMesh mesh;
    support::add_floor(mesh, 10.0);
    support::add_quad(mesh, {2, 0, -10}, {2, 0, 10}, {2, 3, 10}, {2, 3, -10});
    return mesh;
}

/// To a goal in front of the wall, then to a forbidden one behind it.
std::vector<WalkPath> to_the_wall_and_through() {
    return {{"wall", {0, 0, 0}, {{{1, 0, 0}, false}, {{3, 0, 0}, true}}}};
}

WalkScore score_of(const MadeUpWalker::Move& move, int rounds = 3) {
    const TriangleMesh mesh = floor_and_wall();
    MadeUpWalker walker(move);
    return run_walks({{"made up", &walker}}, to_the_wall_and_through(), {}, WalkScorer(mesh), rounds).at(0);
}

TEST(RunWalks, PassesAWalkerThatStopsAtWalls) {
    const WalkScore score = score_of([](const Vec3& foot, const Vec3& desired) {
        const Vec3 there = foot + desired;
        return Vec3(std::min(there.x(), 1.7), there.y(), there.z());
    });
    EXPECT_EQ(score.goals, 1U);
    EXPECT_EQ(score.reached, 1U);
    EXPECT_EQ(score.forbidden_goals, 1U);
    EXPECT_EQ(score.forbidden_reached, 0U);
    EXPECT_EQ(score.crossings, 0U);
    EXPECT_LT(score.max_penetration, 1e-12);
    EXPECT_TRUE(score.failures.empty());
    EXPECT_TRUE(is_correct(score));
    // 0.8 m at 1.4 m/s, then 2 m at that speed and 3 s more.
    EXPECT_NEAR(static_cast<double>(score.ticks), 60.0 * (0.8 / 1.4 + 2.0 / 1.4 + 3.0), 2.0);
}

TEST(RunWalks, FailsAWalkerThatWalksThroughWalls) {
    const WalkScore score =
        score_of([](const Vec3& foot, const Vec3& desired) { return Vec3(foot + desired); });
    EXPECT_EQ(score.reached, 1U);
    EXPECT_EQ(score.forbidden_reached, 1U);
    EXPECT_EQ(score.crossings, 1U);
    EXPECT_NEAR(score.max_penetration, 0.3, 0.02) << "its radius, when the wall is at its axis";
    EXPECT_EQ(score.failures, (std::vector<std::string>{"wall, goal 2"}));
    EXPECT_FALSE(is_correct(score));
}

TEST(RunWalks, FailsAWalkerThatSinksIn) {
    const WalkScore score = score_of([](const Vec3& foot, const Vec3& desired) {
        return Vec3(std::min(foot.x() + desired.x(), 1.75), -0.001, foot.z());
    });
    EXPECT_NEAR(score.max_penetration, 0.05, 1e-9);
    EXPECT_EQ(score.reached, 1U);
    EXPECT_FALSE(is_correct(score));
}

TEST(RunWalks, FailsAWalkerThatGetsNowhere) {
    const WalkScore score = score_of([](const Vec3& foot, const Vec3&) { return foot; });
    EXPECT_EQ(score.reached, 0U);
    EXPECT_EQ(score.forbidden_reached, 0U);
    EXPECT_EQ(score.failures, (std::vector<std::string>{"wall, goal 1"}));
    EXPECT_FALSE(is_correct(score));
}

TEST(RunWalks, FailsAWalkerThatDiffersBetweenRounds) {
    double drift = 0.0;
    const WalkScore score = score_of([&](const Vec3& foot, const Vec3& desired) {
        drift += 1e-9;
        return Vec3(std::min(foot.x() + desired.x(), 1.6) + drift, foot.y(), foot.z());
    });
    EXPECT_EQ(score.differing_paths, 1U);
    EXPECT_FALSE(is_correct(score));
}

TEST(RunWalks, MeasuresTheHeapGrowthOfAWalker) {
    std::vector<std::unique_ptr<std::array<char, 100>>> hoarded;
    hoarded.reserve(10000);
    const auto hoard = [&](const Vec3& foot, const Vec3& desired) {
        hoarded.push_back(std::make_unique<std::array<char, 100>>());
        return Vec3(std::min(foot.x() + desired.x(), 1.6), foot.y(), foot.z());
    };
    EXPECT_FALSE(score_of(hoard, 2).heap_growth.has_value());
    const WalkScore score = score_of(hoard, 3);
    if (heap_in_use() == 0) {
        GTEST_SKIP() << "this build doesn't count its heap";
    }
    EXPECT_GE(score.heap_growth.value_or(0), 100 * score.ticks);
    EXPECT_EQ(score_of([](const Vec3& foot, const Vec3&) { return foot; }).heap_growth, 0U);
}

TEST(RunWalks, ReportsTheLeastTimeOfEachTick) {
    static constexpr double kSlow = 200.0;  // microseconds
    const auto slow_in_the_first_round = [](int& round) {
        return [&round](const Vec3& foot, const Vec3& desired) {
            round += foot.x() == 0.0 ? 1 : 0;
            const auto start = std::chrono::steady_clock::now();
            while (round == 1 && std::chrono::steady_clock::now() - start <
                                     std::chrono::duration<double, std::micro>(kSlow)) {
            }
            return Vec3(std::min(foot.x() + desired.x(), 1.6), foot.y(), foot.z());
        };
    };
    int rounds = 0;
    const WalkScore once = score_of(slow_in_the_first_round(rounds), 1);
    EXPECT_EQ(rounds, 1);
    EXPECT_GE(once.us_p50, kSlow);
    EXPECT_GE(once.us_mean, kSlow);
    EXPECT_LE(once.us_p50, once.us_p99);
    EXPECT_LE(once.us_p99, once.us_max);
    rounds = 0;
    const WalkScore thrice = score_of(slow_in_the_first_round(rounds), 3);
    EXPECT_EQ(rounds, 3);
    EXPECT_LT(thrice.us_p50, kSlow);
}

TEST(WalkScorer, AgreesWithTheTestOracle) {
    const WalkableCampus campus = walkable_campus(1);
    const WalkScorer scorer(campus.mesh);
    collision::World world(std::make_unique<collision::LinearBroadPhase>());
    support::add_object(world, campus.mesh);
    const support::PenetrationOracle oracle(world);
    support::Dice dice(11);
    int inside = 0;
    int crossed = 0;
    for (int i = 0; i < 4000; ++i) {
        // Around the obstacles, most of which are near the middle.
        const Vec3 foot = Vec3(dice.between(-20, 20), dice.between(-1.0, 4.0), dice.between(-20, 20));
        const double depth = oracle.worst_penetration(foot, 0.3, 1.8).depth;
        EXPECT_NEAR(scorer.penetration(foot, 0.3, 1.8), std::max(0.0, depth), 1e-9) << foot.transpose();
        inside += depth > 0.0 ? 1 : 0;
        // An axis without length is a point.
        const Vec3 to = foot + dice.in_cube(0.5);
        const bool crosses = scorer.crosses(foot, to);
        int crossed_triangles = 0;
        const support::Line segment{foot, to};
        if (i % 40 == 0) {
            for (std::size_t t = 0; t < campus.mesh.triangles.size(); ++t) {
                const collision::Triangle c = vertices(campus.mesh, t);
                crossed_triangles += passes_through(segment, support::Vertices{c.a, c.b, c.c}) ? 1 : 0;
            }
            EXPECT_EQ(crosses, crossed_triangles > 0) << foot.transpose();
            crossed += crosses ? 1 : 0;
        }
    }
    EXPECT_GT(inside, 400);
    EXPECT_LT(inside, 3600);
    EXPECT_GT(crossed, 5);
}

/// Counts the allocations of another walker, from its third walk along a path on.
class CountingWalker final : public WalkEngine {
public:
    explicit CountingWalker(WalkEngine& counted) : counted_(counted) {}

    void place(const Vec3& foot) override {
        times_ = foot == start_ ? times_ + 1 : 1;
        start_ = foot;
        counted_.place(foot);
    }
    void walk(const Vec3& desired) override {
        const std::size_t before = collision::allocation_count();
        counted_.walk(desired);
        warm_allocations_ += times_ > 2 ? collision::allocation_count() - before : 0;
        warm_ticks_ += times_ > 2 ? 1 : 0;
    }
    Vec3 foot() const override { return counted_.foot(); }

    std::size_t warm_allocations() const { return warm_allocations_; }
    std::size_t warm_ticks() const { return warm_ticks_; }

private:
    WalkEngine& counted_;
    Vec3 start_ = Vec3::Zero();
    int times_ = 0;
    std::size_t warm_allocations_ = 0;
    std::size_t warm_ticks_ = 0;
};

TEST(OurWalker, ReachesEveryGoalOfASmallCampusWithoutWarmAllocations) {
    const WalkableCampus campus = walkable_campus(1);
    const WalkBody body;
    OurWalker ours(campus.mesh, body);
    CountingWalker counted(ours);
    const WalkScore score =
        run_walks({{"ours", &counted}}, campus.paths, body, WalkScorer(campus.mesh), 3).at(0);
    EXPECT_EQ(score.goals, 23U);
    EXPECT_EQ(score.forbidden_goals, 7U);
    EXPECT_TRUE(is_correct(score)) << testing::PrintToString(score.failures);
    EXPECT_EQ(counted.warm_ticks(), score.ticks);
    EXPECT_EQ(counted.warm_allocations(), 0U);
}

TEST(OurWalker, MeasuresTheMemoryOfItsMover) {
    const WalkableCampus campus = walkable_campus(1);
    OurWalker ours(campus.mesh, {});
    ours.place(campus.paths[0].start);
    ours.walk({0.02, 0.0, 0.0});
    const std::size_t bytes = ours.release_working_memory();
    EXPECT_GE(bytes, sizeof(collision::CapsuleMover));
    EXPECT_LT(bytes, 1U << 20U) << "without the mesh";
}

WalkedCampus made_up_campus(std::size_t triangles, double ours, double bullet, std::size_t memory) {
    WalkedCampus campus;
    campus.triangles = triangles;
    campus.working_memory = memory;
    campus.fastest_peer = bullet;
    for (const auto& [name, mean] : {std::pair("ours", ours), std::pair("bullet", bullet)}) {
        WalkScore score;
        score.controller = name;
        score.us_mean = mean;
        score.us_p50 = 0.5 * mean;
        score.us_p99 = 2.0 * mean;
        score.us_max = 10.0 * mean;
        score.goals = 60;
        score.reached = 60;
        score.max_penetration = 0.25e-4;
        campus.scores.push_back(score);
    }
    campus.scores[1].reached = 58;
    campus.scores[1].forbidden_reached = 2;
    campus.scores[1].crossings = 3;
    return campus;
}

TEST(WalkCsv, HasALinePerCampusAndController) {
    const support::TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "new" / "walk.csv";
    write_walk_csv({made_up_campus(60000, 0.5, 50.0, 100)}, file);
    std::ifstream in(file);
    std::stringstream text;
    text << in.rdbuf();
    EXPECT_EQ(text.str(),
              "triangles,controller,us_mean,us_p50,us_p99,us_max,goals,reached,forbidden,max_penetration_mm,"
              "crossings\n"
              "60000,ours,0.500,0.250,1.000,5.000,60,60,0,0.025,0\n"
              "60000,bullet,50.000,25.000,100.000,500.000,60,58,2,0.025,3\n");
}

const Verdict& verdict(const std::vector<Verdict>& verdicts, const std::string& what) {
    for (const Verdict& each : verdicts) {
        if (each.what.starts_with(what)) {
            return each;
        }
    }
    throw std::out_of_range(what);
}

TEST(WalkVerdicts, CompareScoresWithTargets) {
    const auto all = walk_verdicts(
        {made_up_campus(60000, 0.5, 50.0, 1000), made_up_campus(2000000, 2.0, 70.0, 1201)}, 49.0);
    EXPECT_TRUE(verdict(all, "mean tick, 60000").holds);
    EXPECT_DOUBLE_EQ(*verdict(all, "mean tick, 60000").value, 100.0);
    EXPECT_FALSE(verdict(all, "mean tick, 2000000").holds) << "35 times";
    EXPECT_TRUE(verdict(all, "waypoints missed").holds);
    EXPECT_TRUE(verdict(all, "deepest").holds);
    EXPECT_TRUE(verdict(all, "worst tick").holds);
    EXPECT_FALSE(verdict(all, "growth of working memory").holds);
    EXPECT_FALSE(verdict(all, "growth of the mean").holds) << "4 times, and more than 1/60 of Bullet's";
    EXPECT_TRUE(verdict(all, "two minutes").holds);
    const auto large_but_fast = walk_verdicts(
        {made_up_campus(60000, 0.25, 50.0, 1000), made_up_campus(2000000, 1.0, 61.0, 1000)}, std::nullopt);
    EXPECT_TRUE(verdict(large_but_fast, "growth of the mean").holds);
    EXPECT_FALSE(verdict(large_but_fast, "two minutes").holds) << "not measured";
}

TEST(WalkCase, BetterScoreHasMoreCorrectGoalsThenLessTime) {
    WalkScore a;
    a.goals = 10;
    a.forbidden_goals = 4;
    a.reached = 9;
    a.forbidden_reached = 2;
    a.us_mean = 30.0;
    WalkScore b = a;
    b.us_mean = 20.0;
    EXPECT_EQ(&better(a, b), &b);
    a.forbidden_reached = 1;
    EXPECT_EQ(&better(a, b), &a);
    b.reached = 10;
    EXPECT_EQ(&better(a, b), &b);
}

}  // namespace
}  // namespace campuswalk::tools::bench
