// Whether exactly the allowed goals of a course can be reached, by a flood fill that is independent of the
// mover.

#include "tools/campuswalk_bench/procedural/walk_course.h"

#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/tools/campuswalk_bench/procedural/placement_flood_fill.h"
#include "tools/campuswalk_bench/procedural/walkable_campus.h"

namespace campuswalk::tools::bench {
namespace {

using collision::TriangleMesh;
using collision::Vec3;

/// Slightly smaller than an avatar: what it can't reach, an avatar can't.
constexpr FloodBody kSlim{0.27, 1.79, 0.305, 0.6225146366376195};  // 51.5 degrees
constexpr double kFine = 0.04;
// With half a cell's diagonal it is still narrower than an avatar, so that no path between cells is missed.
static_assert(kSlim.radius + 0.71 * kFine < 0.3);

/// Slightly larger than an avatar: what it can reach, an avatar can.
constexpr FloodBody kStout{0.33, 1.85, 0.285, 0.6626200482157375};  // 48.5 degrees
constexpr double kCoarse = 0.08;
constexpr double kAside = 1.2;  ///< metres from the straight line to a goal

struct Course {
    TriangleMesh mesh;
    std::vector<WalkPath> paths;
};

Course course_on_flat_ground(int difficulty) {
    Course course;
    scene::MeshParts parts(course.mesh);
    const double half = kCourseRadius;
    parts.add_quad({-half, 0, half}, {half, 0, half}, {half, 0, -half}, {-half, 0, -half});
    add_course(parts, {}, course_sizes(difficulty), course.paths);
    return course;
}

void expect_reachable(const TriangleMesh& mesh, const std::vector<WalkPath>& paths) {
    StandingFlood stout(mesh, kStout, kCoarse);
    for (const WalkPath& path : paths) {
        Vec3 from = path.start;
        for (const WalkGoal& goal : path.goals) {
            if (!goal.forbidden) {
                EXPECT_TRUE(stout.leads(from, goal.at, kAside))
                    << path.name << ": to " << goal.at.transpose();
            }
            from = goal.at;
        }
    }
}

class WalkCourse : public testing::TestWithParam<int> {};

TEST_P(WalkCourse, AllowedGoalsAreReachableNearlyStraight) {
    const Course course = course_on_flat_ground(GetParam());
    expect_reachable(course.mesh, course.paths);
}

TEST_P(WalkCourse, ForbiddenGoalsAreUnreachable) {
    const Course course = course_on_flat_ground(GetParam());
    StandingFlood slim(course.mesh, kSlim, kFine);
    int forbidden = 0;
    for (const WalkPath& path : course.paths) {
        for (const WalkGoal& goal : path.goals) {
            if (goal.forbidden) {
                const double away = (path.start - goal.at).norm();
                EXPECT_FALSE(slim.is_open(goal.at, 0.9 * away)) << path.name;
                ++forbidden;
            }
        }
    }
    EXPECT_EQ(forbidden, 7);
}

TEST_P(WalkCourse, ForbiddenGoalsBecomeReachableWithEasierSizes) {
    CourseSizes easy = course_sizes(GetParam());
    easy.too_high = 0.25;
    easy.too_steep = 45.0;
    easy.too_narrow = 0.75;
    easy.too_low = 1.95;
    TriangleMesh mesh;
    scene::MeshParts parts(mesh);
    std::vector<WalkPath> paths;
    const double half = kCourseRadius;
    parts.add_quad({-half, 0, half}, {half, 0, half}, {half, 0, -half}, {-half, 0, -half});
    add_course(parts, {}, easy, paths);
    StandingFlood stout(mesh, kStout, kCoarse);
    int open = 0;
    for (const WalkPath& path : paths) {
        if (path.goals.front().forbidden) {
            open += stout.leads(path.start, path.goals.front().at, kAside) ? 1 : 0;
        }
    }
    EXPECT_EQ(open, 4) << "but for the wall, the bars and the closed room";
}

INSTANTIATE_TEST_SUITE_P(EasyToHard, WalkCourse,
                         testing::ValuesIn(support::kSanitized ? std::vector<int>{8}
                                                               : std::vector<int>{0, 4, 8}));

TEST(WalkableCampus, HillPathsAreReachable) {
    const WalkableCampus campus = walkable_campus(1);
    std::vector<WalkPath> hills;
    for (const WalkPath& path : campus.paths) {
        if (path.name == "hill") {
            hills.push_back(path);
        }
    }
    ASSERT_EQ(hills.size(), 1U);
    expect_reachable(campus.mesh, hills);
}

TEST(WalkableCampus, AllLotsOfAThreeByThreeCampusHavePaths) {
    const WalkableCampus campus = walkable_campus(3);
    EXPECT_NEAR(static_cast<double>(campus.mesh.triangles.size()), 65e3, 3e3);
    std::size_t goals = 0;
    std::size_t forbidden = 0;
    for (const WalkPath& path : campus.paths) {
        for (const WalkGoal& goal : path.goals) {
            (goal.forbidden ? forbidden : goals) += 1;
        }
    }
    EXPECT_EQ(campus.paths.size(), 144U);
    EXPECT_EQ(goals, 207U);
    EXPECT_EQ(forbidden, 63U);
}

TEST(WalkableCampus, PathsOfALargeCampusSpreadFromEndToEnd) {
    const WalkableCampus campus = walkable_campus(17);
    EXPECT_NEAR(static_cast<double>(campus.mesh.triangles.size()), 2.09e6, 2e4);
    EXPECT_EQ(campus.paths.size(), 144U);
    Vec3 low = campus.paths[0].start;
    Vec3 high = low;
    for (const WalkPath& path : campus.paths) {
        low = low.cwiseMin(path.start);
        high = high.cwiseMax(path.start);
    }
    EXPECT_GT(high.x() - low.x(), 14 * 72.0);
    EXPECT_GT(high.z() - low.z(), 14 * 72.0);
}

}  // namespace
}  // namespace campuswalk::tools::bench
