// Traps among pits that one gets out of, on one thread and on several.

#include "engine/walkspace/passage/traps.h"
#include "engine/walkspace/explore/campus_settings.h"

#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/walkspace/report/walk_report.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

constexpr int kPits = 10;       // in a row, and rows: with more traps than are walked from at once
constexpr double kPitch = 3.0;  // from one pit to the next
constexpr double kSide = 1.6;   // of a pit
constexpr double kGap = kPitch - kSide;
constexpr double kDeck = 0.5;    // above the pits' floor
constexpr double kBench = 0.25;  // one steps up to it, and from it to the deck

using PitNumber = std::pair<int, int>;

/// Every third one along each row and column.
bool has_bench(const PitNumber& pit) {
    return (pit.first + pit.second) % 3 == 0;
}

Eigen::Vector3d min_of(const PitNumber& pit) {
    return {kPitch * pit.first, 0, kPitch * pit.second};
}

/// A deck of pits within walls; along one side of some is a bench.
scene::Campus pits() {
    constexpr double kLow = -kGap;
    constexpr double kHigh = kPitch * kPits;
    scene::Campus campus = level_campus();
    for (int row = -1; row < kPits; ++row) {
        const double z = kPitch * row + kSide;
        add_box(campus, "deck/row-" + std::to_string(row), {kLow, -0.1, z}, {kHigh, kDeck, z + kGap});
        for (int column = -1; row >= 0 && column < kPits; ++column) {
            const double x = kPitch * column + kSide;
            add_box(campus, "deck/" + std::to_string(row) + "-" + std::to_string(column),
                    {x, -0.1, z - kSide}, {x + kGap, kDeck, z});
        }
    }
    for (int k = 0; k < kPits * kPits; ++k) {
        if (const PitNumber pit{k % kPits, k / kPits}; has_bench(pit)) {
            const Eigen::Vector3d min = min_of(pit);
            add_box(campus, "bench-" + std::to_string(k), min, min + Eigen::Vector3d(0.7, kBench, kSide));
        }
    }
    add_box(campus, "wall/west", {kLow - 0.2, 0, kLow}, {kLow, 3, kHigh});
    add_box(campus, "wall/east", {kHigh, 0, kLow}, {kHigh + 0.2, 3, kHigh});
    add_box(campus, "wall/south", {kLow, 0, kLow - 0.2}, {kHigh, 3, kLow});
    add_box(campus, "wall/north", {kLow, 0, kHigh}, {kHigh, 3, kHigh + 0.2});
    return campus;
}

std::vector<Trap> traps_in(const scene::Campus& campus, std::size_t workers) {
    const WorkerWorlds worlds(campus.world, workers,
                              [] { return std::make_unique<collision::LinearBroadPhase>(); });
    ExploreSettings settings = explore_settings(campus, AvatarProfile(), 60);
    settings.starts = {{-1, kDeck, -1}};
    const WalkSpace space = explore(worlds, settings);
    std::vector<Trap> traps = find_traps(worlds, settings, space);
    for (Trap& trap : traps) {
        trap.edge.y() -= trap.drop;  // where its floor is
    }
    return traps;
}

/// That the body stood beside before it fell.
PitNumber pit_beside(const Eigen::Vector3d& foot) {
    const auto nearest = [](double at) { return static_cast<int>(std::lround((at - kSide / 2) / kPitch)); };
    return {nearest(foot.x()), nearest(foot.z())};
}

TEST(Traps, AreThePitsWithoutABench) {
    const std::vector<Trap> traps = traps_in(pits(), 1);
    std::set<PitNumber> found;
    for (const Trap& trap : traps) {
        found.insert(pit_beside(trap.edge));
        EXPECT_NEAR(trap.edge.y(), 0.0, 0.05);
    }
    EXPECT_EQ(found.size(), traps.size());
    for (int k = 0; k < kPits * kPits; ++k) {
        const PitNumber pit{k % kPits, k / kPits};
        EXPECT_NE(found.contains(pit), has_bench(pit)) << pit.first << " " << pit.second;
    }
}

TEST(Traps, AreTheSameForAnyNumberOfWorkers) {
    const scene::Campus campus = pits();
    const std::vector<Trap> one = traps_in(campus, 1);
    const std::vector<Trap> three = traps_in(campus, 3);
    ASSERT_EQ(one.size(), three.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].nodes, three[i].nodes);
        EXPECT_EQ(one[i].edge, three[i].edge);
    }
}

/// A bridge 3 m above two floors of 4 m by 4 m, with 1 m of nothing between them.
scene::Campus floors_below_a_bridge() {
    scene::Campus campus = empty_campus();
    add_box(campus, "west", {-4.5, -1, -2}, {-0.5, 0, 2});
    add_box(campus, "east", {0.5, -1, -2}, {4.5, 0, 2});
    add_box(campus, "bridge", {-1, 2.6, -9}, {1, 3, -1});
    return campus;
}

std::vector<Trap> traps_below_the_bridge(bool jump) {
    const scene::Campus campus = floors_below_a_bridge();
    const WorkerWorlds worlds(campus.world, 1, {});
    ExploreSettings settings = explore_settings(campus, AvatarProfile(), 60);
    settings.starts = {{0, 3, -5}};
    settings.jump = jump;
    return find_traps(worlds, settings, explore(worlds, settings));
}

TEST(Traps, AreOneWhereOneJumpsThereAndBack) {
    EXPECT_EQ(traps_below_the_bridge(false).size(), 2U);
    const std::vector<Trap> traps = traps_below_the_bridge(true);
    ASSERT_EQ(traps.size(), 1U);
    EXPECT_NEAR(traps[0].edge.y(), 3.0, 0.01) << "one got in from the bridge";
    EXPECT_NEAR(traps[0].drop, 3.0, 0.3);
}

TEST(Traps, AreNoneWhereAJumpLeadsOut) {
    scene::Campus campus = pits();
    const WorkerWorlds worlds(campus.world, 1, {});
    ExploreSettings settings = explore_settings(campus, AvatarProfile(), 60);
    settings.starts = {{-1, kDeck, -1}};
    settings.jump = true;
    EXPECT_TRUE(find_traps(worlds, settings, explore(worlds, settings)).empty());
}

}  // namespace
}  // namespace campuswalk::engine
