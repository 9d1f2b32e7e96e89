// Passages that are narrower than asked for: behind one another, and beside wider ones.

#include "engine/walkspace/passage/bottlenecks.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "collision/world/bullet_broad_phase.h"
#include "tests/engine/small_campus.h"
#include "tests/engine/walkspace/explore/explored_ground.h"

namespace campuswalk::engine {
namespace {

/// A gap in a wall across the yard, from one z to another.
struct Gap {
    double from = 0.0;
    double to = 0.0;
};

/// A wall of 0.1 m at this x, from one side of the yard to the other.
void add_wall(scene::Campus& campus, const std::string& name, double x, const std::vector<Gap>& gaps) {
    double from = -6.0;
    int piece = 0;
    const auto add_piece = [&](double to) {
        add_box(campus, name + "-" + std::to_string(piece++), {x - 0.05, 0, from}, {x + 0.05, 3, to});
    };
    for (const Gap& gap : gaps) {
        add_piece(gap.from);
        from = gap.to;
    }
    add_piece(6.0);
}

class Bottlenecks : public testing::Test {
protected:
    /// By their x.
    std::vector<Bottleneck> find(double width, std::size_t workers = 1) {
        const WorkerWorlds worlds(campus_.world, workers, collision::make_bullet_broad_phase);
        const ExploreSettings settings = explore_from({-5, 0, 0});
        const WalkSpace space = explored(campus_.world, settings);
        std::vector<Bottleneck> found = find_bottlenecks(worlds, settings, space, width);
        const auto millimetres = [](const Bottleneck& b) { return std::floor(1e3 * b.passage.width + 0.5); };
        EXPECT_TRUE(std::ranges::is_sorted(found, {}, millimetres));
        std::ranges::stable_sort(found, {}, [](const Bottleneck& b) { return b.passage.foot.x(); });
        return found;
    }

    std::string name_of(const PassageSide& side) const { return campus_.objects[index_of(side.object)].id; }

    scene::Campus campus_ = walled_yard();
};

TEST_F(Bottlenecks, LieBehindOneAnother) {
    add_wall(campus_, "first", -2.0, {{1.0, 1.9}});
    add_wall(campus_, "second", 1.03, {{-3.0, -2.3}});
    add_wall(campus_, "third", 3.0, {{0.0, 1.5}});
    const std::vector<Bottleneck> found = find(1.2);
    ASSERT_EQ(found.size(), 2);
    EXPECT_NEAR(found[0].passage.width, 0.9, 1e-3);
    EXPECT_NEAR(found[0].passage.foot.x(), -2.0, 0.06);
    EXPECT_NEAR(found[1].passage.width, 0.7, 1e-3);
    EXPECT_NEAR(found[1].passage.foot.x(), 1.03, 0.06);
    std::vector<std::string> sides{name_of(found[1].passage.sides[0]), name_of(found[1].passage.sides[1])};
    std::ranges::sort(sides);
    EXPECT_EQ(sides, (std::vector<std::string>{"second-0", "second-1"}));
    EXPECT_TRUE(found[0].is_only_path);
    EXPECT_TRUE(found[1].is_only_path);
    EXPECT_EQ(find(1.6).size(), 3);
    EXPECT_EQ(find(0.8).size(), 1);
}

/// Nodes may be half a cell before or behind a thin wall, and beside the middle of the door.
TEST_F(Bottlenecks, AreFoundWhereverTheyLieInTheirCells) {
    for (const double width : {0.9, 1.2}) {
        for (const double x : {0.0, 0.03, 0.07, 0.11, 0.125, 0.16, 0.2}) {
            for (const double z : {0.0, 0.04, 0.09, 0.125, 0.17}) {
                campus_ = walled_yard();
                const double gap = width - 0.03;
                add_wall(campus_, "wall", x, {{z - 0.5 * gap, z + 0.5 * gap}});
                const std::vector<Bottleneck> found = find(width);
                ASSERT_EQ(found.size(), 1) << width << " at " << x << ", " << z;
                EXPECT_NEAR(found[0].passage.width, gap, 2e-3);
                EXPECT_TRUE(found[0].is_only_path);
            }
        }
    }
}

TEST_F(Bottlenecks, LieBesideWiderPassages) {
    add_wall(campus_, "wall", 0.0, {{-4.0, -3.2}, {2.0, 4.0}});
    const std::vector<Bottleneck> found = find(1.2);
    ASSERT_EQ(found.size(), 1);
    EXPECT_NEAR(found[0].passage.width, 0.8, 1e-3);
    EXPECT_FALSE(found[0].is_only_path);
}

TEST_F(Bottlenecks, TheWidestOfTwoIsTheOnlyPath) {
    add_wall(campus_, "wall", 0.1, {{-4.0, -3.2}, {2.0, 3.1}});
    std::vector<Bottleneck> found = find(1.2);
    ASSERT_EQ(found.size(), 2);
    std::ranges::sort(found, {}, [](const Bottleneck& b) { return b.passage.width; });
    EXPECT_NEAR(found[0].passage.width, 0.8, 1e-3);
    EXPECT_FALSE(found[0].is_only_path);
    EXPECT_NEAR(found[1].passage.width, 1.1, 1e-3);
    EXPECT_TRUE(found[1].is_only_path);
}

TEST_F(Bottlenecks, DoorsOffANarrowCorridor) {
    add_wall(campus_, "left", -0.6, {{-5.0, -4.3}, {3.0, 3.8}});
    add_wall(campus_, "right", 0.6, {{-1.0, -0.3}});
    const std::vector<Bottleneck> found = find(1.2);
    ASSERT_EQ(found.size(), 3);
    EXPECT_NEAR(found[2].passage.width, 0.7, 1e-3);
    EXPECT_NEAR(found[2].passage.foot.x(), 0.6, 0.06);
    EXPECT_TRUE(found[2].is_only_path);
}

TEST_F(Bottlenecks, NichesArent) {
    add_box(campus_, "cupboard-1", {-6, 0, 2}, {-5, 2, 4});
    add_box(campus_, "cupboard-2", {-6, 0, 5}, {-5, 2, 6});
    EXPECT_TRUE(find(1.2).empty());
}

TEST_F(Bottlenecks, AreFoundBesideAPillar) {
    add_box(campus_, "pillar", {5.0, 0, 1}, {5.3, 3, 1.3});
    const std::vector<Bottleneck> found = find(1.2);
    ASSERT_EQ(found.size(), 1);
    EXPECT_FALSE(found[0].is_only_path);
    EXPECT_NEAR(found[0].passage.foot.z(), 1.15, 0.3);
}

TEST_F(Bottlenecks, AreTheSameForAnyNumberOfWorkers) {
    add_wall(campus_, "first", -2.0, {{1.0, 1.9}, {3.0, 3.7}});
    add_wall(campus_, "second", 1.03, {{-3.0, -2.3}});
    const std::vector<Bottleneck> one = find(1.2);
    const std::vector<Bottleneck> three = find(1.2, 3);
    ASSERT_EQ(one.size(), three.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].passage.foot, three[i].passage.foot);
        EXPECT_EQ(one[i].passage.width, three[i].passage.width);
    }
}

}  // namespace
}  // namespace campuswalk::engine
