// Which starts' grounds no path joins, in yards of known size side by side.

#include "engine/walkspace/space/separate_grounds.h"
#include "engine/walkspace/explore/campus_settings.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/walkspace/report/walk_report.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

using collision::Vec3;

constexpr double kSide = 6.0;
constexpr double kThick = 0.4;

/// Yards in a row along x, between walls of 3 m; `sills`: the heights of those between them.
scene::Campus yards(const std::vector<double>& sills) {
    scene::Campus campus = level_campus();
    const double end = kSide * static_cast<double>(sills.size() + 1);
    add_box(campus, "wall/south", {-kThick, 0, kSide}, {end + kThick, 3, kSide + kThick});
    add_box(campus, "wall/north", {-kThick, 0, -kThick}, {end + kThick, 3, 0});
    add_box(campus, "wall/west", {-kThick, 0, 0}, {0, 3, kSide});
    add_box(campus, "wall/east", {end, 0, 0}, {end + kThick, 3, kSide});
    for (std::size_t i = 0; i < sills.size(); ++i) {
        const double x = kSide * static_cast<double>(i + 1);
        add_box(campus, "sill/" + std::to_string(i), {x - 0.5 * kThick, 0, 0},
                {x + 0.5 * kThick, sills[i], kSide});
    }
    return campus;
}

/// In the middle of a yard.
Vec3 in_yard(int yard) {
    return {kSide * (yard + 0.5), 0.0, 0.5 * kSide};
}

std::vector<SeparateGround> grounds_of(const scene::Campus& campus, const std::vector<Vec3>& starts) {
    const WorkerWorlds worlds(campus.world, 1, {});
    ExploreSettings settings = explore_settings(campus, AvatarProfile(), 60);
    settings.starts = starts;
    return find_separate_grounds(explore(worlds, settings), settings.strides.body.step_height);
}

TEST(SeparateGrounds, AreThoseThatWallsPart) {
    const auto found = grounds_of(yards({2.0, 0.2, 2.0}), {in_yard(1), in_yard(3), in_yard(2), in_yard(0)});
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0].starts, (std::vector<std::uint32_t>{0, 2})) << "over a sill that is stepped over";
    EXPECT_EQ(found[1].starts, (std::vector<std::uint32_t>{1}));
    EXPECT_EQ(found[2].starts, (std::vector<std::uint32_t>{3}));
    const double wide = kSide - 0.5 * kThick - 0.6;  // for the body's middle, beside the wall at the end
    EXPECT_NEAR(found[1].area, wide * (kSide - 0.6), 3.0);
    EXPECT_NEAR(found[0].area, (2 * kSide - kThick - 0.6) * (kSide - 0.6), 5.0);
}

TEST(SeparateGrounds, AreNoneWhereAllIsOne) {
    EXPECT_TRUE(grounds_of(yards({2.0}), {in_yard(0)}).empty());
    EXPECT_TRUE(grounds_of(yards({2.0}), {in_yard(0), in_yard(0) + Vec3(1.0, 0.0, 1.0)}).empty());
    EXPECT_TRUE(grounds_of(yards({0.3, 0.1}), {in_yard(0), in_yard(1), in_yard(2)}).empty());
    EXPECT_TRUE(grounds_of(yards({}), {}).empty());
}

TEST(SeparateGrounds, OneThatOneOnlyFallsIntoIsNot) {
    scene::Campus campus = yards({});
    add_box(campus, "platform", {0, 0, 0}, {2, 2, kSide});
    EXPECT_TRUE(grounds_of(campus, {in_yard(0), {1, 2, 3}}).empty());
}

}  // namespace
}  // namespace campuswalk::engine
