// The conformance course on third-party models: goals marked as reachable are reached, the others are not,
// and no tick ends inside anything or passes through it.

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "collision/world/bullet_broad_phase.h"
#include "scene/campus/campus.h"
#include "tests/collision/course/course_scene.h"
#include "tests/support/angles.h"
#include "tests/support/effort.h"

namespace campuswalk::collision::course {
namespace {

using support::radians;

namespace fs = std::filesystem;

struct RealCourse {
    std::string name;
    std::string model;        ///< below the shared data
    MoverSettings body;       ///< the course's own
    bool add_floor = false;   ///< at height 0, where the model is furniture without ground
    std::vector<Vec3> route;  ///< feet; the first is where it starts
    bool reached = true;      ///< the last point of the route; those before it always are
};

void PrintTo(const RealCourse& course, std::ostream* out) {
    *out << course.name;
}

World load_world(const RealCourse& course, const fs::path& model) {
    scene::CampusDescription description;
    description.name = course.name;
    scene::SceneFile file;
    file.file = course.model;
    file.path = model;
    description.scenes = {file};
    scene::ColliderDescription all;
    all.id = "model";
    all.nodes = {{{}, "*"}};
    all.shape = scene::MeshShape{};
    all.modes.solid = true;
    description.colliders = {all};
    std::vector<scene::Diagnostic> warnings;
    World world = scene::load_campus(std::move(description), make_bullet_broad_phase(), warnings).world;
    if (course.add_floor) {
        TriangleMesh floor;
        support::add_floor(floor, 60.0);
        support::add_object(world, std::move(floor));
    }
    return world;
}

class RealCourses : public testing::TestWithParam<RealCourse> {};

TEST_P(RealCourses, ReachesExactlyTheReachableGoals) {
    const RealCourse& course = GetParam();
    const fs::path model = fs::path(CAMPUSWALK_SOURCE_DIR) / ".." / "shared" / "data" / course.model;
    if (!fs::exists(model)) {
        GTEST_SKIP() << "no model at ../shared/data/" << course.model;
    }
    const World world = load_world(course, model);
    AuditedBody body(world, course.body);
    body.stand(course.route.front() + Vec3(0, 0.1, 0), 0.5);
    ASSERT_TRUE(body.state().grounded);
    for (std::size_t i = 1; i < course.route.size(); ++i) {
        const Vec3& goal = course.route[i];
        SCOPED_TRACE(testing::Message() << "on the way to point " << i << ", " << goal.transpose());
        const double straight = (goal - course.route[i - 1]).norm();
        const bool there = reach(body, goal, kPace, 2.0 * straight / kPace + 1.0);
        ASSERT_FALSE(HasFatalFailure());
        const bool expected = course.reached || i + 1 < course.route.size();
        ASSERT_EQ(there && std::abs(body.foot().y() - goal.y()) < 0.1, expected)
            << "it is at " << body.foot().transpose();
    }
}

MoverSettings body_of(double step_height, double max_slope_degrees = 50.0) {
    MoverSettings body;
    body.step_height = step_height;
    body.min_up = std::cos(radians(max_slope_degrees));
    return body;
}

/// Up all ramps to where the last one ends at a parapet; the decks are 5.57 m apart.
std::vector<Vec3> garage_route() {
    std::vector<Vec3> route = {{20, 0.23, 0}};
    for (int deck = 0; deck < 7; ++deck) {
        const double high = deck == 0 ? 0.22 : 5.79 + 5.565 * (deck - 1);
        const double next = 5.79 + 5.565 * deck;
        route.insert(route.end(), {{5, high, 9}, {4, high + 0.1, 8}, {4, next - 0.09, -8}});
        if (deck < 6) {
            route.insert(route.end(), {{5, next, -9}, {20, next, 0}});
        }
    }
    return route;
}

/// Into offices and out again, through some twenty doors of the building.
const std::vector<Vec3> kOffices = {
    {7.05, 0, -42.95},  {6.25, 0, -40.45},  {6.55, 0, -39.95},  {13.65, 0, -39.95}, {13.95, 0, -40.25},
    {14.05, 0, -42.95}, {14.05, 0, -40.25}, {14.45, 0, -39.25}, {23.85, 0, -39.95}, {36.95, 0, -40.05},
    {37.45, 0, -40.55}, {37.55, 0, -41.25}, {39.15, 0, -42.85}, {40.05, 0, -43.25}, {37.85, 0, -41.55},
    {37.35, 0, -40.45}, {36.35, 0, -39.45}, {34.15, 0, -39.45}, {33.85, 0, -39.15}, {33.85, 0, -35.75},
    {34.25, 0, -34.45}, {40.05, 0, -32.95}, {34.25, 0, -33.45}, {32.35, 0, -31.45}, {32.35, 0, -29.15},
    {32.05, 0, -28.85}, {22.65, 0, -28.65}, {23.75, 0, -27.45}, {23.95, 0, -26.95}, {24.95, 0, -25.95},
    {26.05, 0, -25.95}, {26.35, 0, -25.65}, {26.35, 0, -25.05}, {25.95, 0, -24.65}, {25.65, 0, -24.65},
    {25.35, 0, -24.35}, {24.35, 0, -20.35}, {23.95, 0, -19.75}, {23.75, 0, -14.55}, {22.45, 0, -11.35},
    {22.15, 0, -10.85}, {20.05, 0, -9.95},  {22.15, 0, -10.85}, {22.65, 0, -11.85}, {22.95, 0, -12.15},
    {27.05, 0, -11.75}, {32.05, 0, -9.45}};

/// Six treads of 10 cm, a beam 30 cm wide, three treads of 15 cm.
const std::vector<Vec3> kRealStairs = {{-0.5, 0, -0.8},     {2.25, 0.6, -0.8}, {2.25, 0.6, -0.15},
                                       {-1.75, 0.6, -0.15}, {-1.75, 0, -2.2},  {-1.75, 0.6, -0.15},
                                       {2.25, 0.6, -0.15},  {2.25, 0.6, -0.8}, {-0.5, 0, -0.8}};

const std::vector<Vec3> kUfazStairs = {{10.5, 0.45, -10}, {10.5, 3.45, -16.2}, {10.5, 4.55, -20}};
const std::vector<Vec3> kUfazFromTheFloor = {{10.5, 0, -5}, {10.5, 3.45, -16.2}, {10.5, 4.55, -20}};
const std::vector<Vec3> kUfazFirstRiser = {{10.5, 0, -5}, {10.5, 0.45, -10}};
const std::vector<Vec3> kUfazUnderTheStairs = {{4, 0, -15}, {4, 0, -20.2}, {10.5, 0, -20.2}};

INSTANTIATE_TEST_SUITE_P(
    Models, RealCourses,
    testing::Values(
        RealCourse{"staircases", "collision/staircases_koroibot_hr.dae", body_of(0.3), true, kRealStairs},
        RealCourse{"nist_stairs",
                   "gazebo/nist_stairs_120/meshes/nist_stairs_120.dae",
                   body_of(0.3),
                   true,
                   {{0, 0, 1.3}, {0, 1.03, -0.5}, {0, 0, 1.3}}},
        RealCourse{"parking_garage", "gazebo/parking_garage/meshes/parking_garage.dae", body_of(0.3), false,
                   garage_route()},
        RealCourse{"willowgarage", "gazebo/willowgarage/meshes/willowgarage_collision.dae", body_of(0.3),
                   true, kOffices},
        // The landing covered the last tread before; the lowest riser, 0.45 m, has always been there.
        RealCourse{"ufaz_landing_128", "ufaz/before128/ufaz-floor.obj", body_of(0.4, 46.0), false,
                   kUfazStairs, false},
        RealCourse{"ufaz_landing_150", "ufaz/after150/ufaz-floor.obj", body_of(0.4, 46.0), false,
                   kUfazStairs},
        RealCourse{"ufaz_from_floor_128", "ufaz/before128/ufaz-floor.obj", body_of(0.46, 46.0), false,
                   kUfazFromTheFloor, false},
        RealCourse{"ufaz_from_floor_150", "ufaz/after150/ufaz-floor.obj", body_of(0.46, 46.0), false,
                   kUfazFromTheFloor},
        RealCourse{"ufaz_first_riser", "ufaz/after150/ufaz-floor.obj", body_of(0.4, 46.0), false,
                   kUfazFirstRiser, false},
        RealCourse{"ufaz_under_150", "ufaz/after150/ufaz-floor.obj", body_of(0.4, 46.0), false,
                   kUfazUnderTheStairs, false},
        RealCourse{"ufaz_under_152", "ufaz/after152/ufaz-floor.obj", body_of(0.4, 46.0), false,
                   kUfazUnderTheStairs}),
    [](const auto& course) { return course.param.name; });

}  // namespace
}  // namespace campuswalk::collision::course
