#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "engine/expect/route_evaluators.h"
#include "tests/engine/small_campus.h"

// What the campus lets a visitor walk, as an expectation.

namespace campuswalk::engine {
namespace {

using testing::HasSubstr;

Target at(const std::string& label, double x, double z) {
    return {label, {x, 0, z}, true};
}

/// A wall with a door of 1.2 m between the two places, 20 m apart.
scene::Campus divided_by_a_wall() {
    scene::Campus campus = level_campus(15.0);
    add_box(campus, "wall/left", {-15, 0, -0.1}, {-0.6, 3, 0.1});
    add_box(campus, "wall/right", {0.6, 0, -0.1}, {15, 3, 0.1});
    return campus;
}

ExpectRoute route_between(double x) {
    ExpectRoute route;
    route.from = at("south", x, 10);
    route.to = at("north", x, -10);
    return route;
}

TEST(RouteCheck, TellsHowLongTheRouteIs) {
    const scene::Campus campus = divided_by_a_wall();
    const AvatarProfile avatar;
    const Finding found =
        check_route(ExpectReachable{{}, at("south", 0, 10), at("north", 0, -10)}, {campus, avatar});
    EXPECT_TRUE(found.holds);
    EXPECT_THAT(found.message, HasSubstr("a route of 19.9"));
    EXPECT_FALSE(found.can_change);
}

TEST(RouteCheck, SaysWhyNot) {
    scene::Campus campus = divided_by_a_wall();
    add_box(campus, "door", {-0.6, 0, -0.05}, {0.1, 2, 0.05});
    const AvatarProfile avatar;
    const Finding found =
        check_route(ExpectReachable{{}, at("south", 0, 10), at("north", 0, -10)}, {campus, avatar});
    EXPECT_FALSE(found.holds);
    EXPECT_THAT(found.message, HasSubstr("door stands in the way"));
    EXPECT_THAT(found.message, HasSubstr("0.50 m wide, the body needs 0.60 m"));
    EXPECT_FALSE(check_route(route_between(0), {campus, avatar}).holds);
}

TEST(RouteCheck, DoesNotTakeASearchThatWasCutForNoRoute) {
    scene::Campus campus = level_campus(15.0);
    add_box(campus, "wall", {-15, 0, -0.1}, {15, 3, 0.1});
    const AvatarProfile avatar;
    const ExpectReachable reachable{{}, at("south", 0, 10), at("north", 0, -10)};
    EXPECT_EQ(failure_code(check_route(reachable, {campus, avatar}), "reachable", true), std::nullopt);
    const Finding found = check_route(reachable, {campus, avatar}, 200);
    EXPECT_THAT(found.message,
                testing::MatchesRegex("it isn't known whether a route leads to north from south: "
                                      "the search ended after [0-9]+ m² of ground, .*"));
    EXPECT_EQ(failure_code(found, "reachable", false), kRouteUnknown);
    EXPECT_EQ(failure_code(found, "reachable", true), kRouteUnknown);
    ExpectRoute route;
    route.from = reachable.from;
    route.to = reachable.to;
    EXPECT_EQ(failure_code(check_route(route, {campus, avatar}, 200), "route", true), kRouteUnknown);
}

TEST(RouteCheck, MayBeAboutAnotherVisitor) {
    scene::Campus campus = divided_by_a_wall();
    add_box(campus, "sill", {-0.6, 0, -0.1}, {0.6, 0.2, 0.1});
    const AvatarProfile adult;
    AvatarProfile robot;
    robot.step_height = 0.1;
    const EvaluatorContext context{campus, adult};
    ExpectReachable reachable{{}, at("south", 0, 10), at("north", 0, -10)};
    EXPECT_TRUE(check_route(reachable, context).holds);
    reachable.avatar = robot;
    EXPECT_THAT(check_route(reachable, context).message,
                testing::MatchesRegex(
                    ".*: riser of 0\\.20 m at sill, .*, 0\\.20, 0\\.10; the avatar steps 0\\.10 m"));
    ExpectRoute route = route_between(0);
    EXPECT_TRUE(check_route(route, context).holds);
    route.avatar = robot;
    EXPECT_FALSE(check_route(route, context).holds);
    EXPECT_TRUE(check_route(reachable, {divided_by_a_wall(), adult}).holds);
}

TEST(RouteCheck, LimitsLengthAndWidth) {
    const scene::Campus campus = divided_by_a_wall();
    const AvatarProfile avatar;
    const EvaluatorContext context{campus, avatar};
    ExpectRoute route = route_between(0);
    EXPECT_TRUE(check_route(route, context).holds);
    route.max_length = 20.1;
    route.min_width = 1.15;
    EXPECT_TRUE(check_route(route, context).holds);
    route.min_width = 1.25;
    EXPECT_THAT(check_route(route, context).message, HasSubstr("is 1.200 m wide at"));
    route = route_between(8);  // through the door, past its frame: 2 * sqrt(7.7^2 + 10^2) = 25.24
    route.max_length = 25.2;
    EXPECT_FALSE(check_route(route, context).holds);
    route.max_length = 25.8;
    EXPECT_TRUE(check_route(route, context).holds);
}

TEST(RouteCheck, LimitsTheSlope) {
    scene::Campus campus = level_campus(15.0);
    const double slope = 10.0 * std::numbers::pi / 180.0;
    collision::Object ramp;
    ramp.shape = collision::Box{{15, 0.1, 4}};
    ramp.X_world_shape.rotation = Eigen::AngleAxisd(slope, Eigen::Vector3d::UnitX()).toRotationMatrix();
    campus.objects.push_back({"ramp", {}, {}});
    campus.world.add(ramp);
    const AvatarProfile avatar;
    ExpectRoute route = route_between(0);
    route.max_slope = slope + 0.01;
    EXPECT_TRUE(check_route(route, {campus, avatar}).holds);
    route.max_slope = slope - 0.01;
    EXPECT_THAT(check_route(route, {campus, avatar}).message, HasSubstr("slope of 10.0 degrees"));
}

TEST(RouteCheck, AVisitorMustFitAtTheStart) {
    scene::Campus campus = level_campus(15.0);
    add_box(campus, "block", {-4, 0, 8}, {4, 5, 14});
    const AvatarProfile avatar;
    const Finding found =
        check_route(ExpectReachable{{}, at("south", 0, 11), at("north", 0, -10)}, {campus, avatar});
    EXPECT_FALSE(found.holds);
    EXPECT_THAT(found.message, HasSubstr("the avatar doesn't fit at south"));
}

}  // namespace
}  // namespace campuswalk::engine
