#include "engine/walkspace/route/route_facts.h"
#include "engine/walkspace/explore/campus_settings.h"

#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/walkspace/report/walk_report.h"
#include "engine/walkspace/route/route.h"
#include "engine/walkspace/stride/trial_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine {
namespace {

using collision::Vec3;

RouteFacts facts_between(const scene::Campus& campus, const Vec3& from, const Vec3& to) {
    const ExploreSettings exploration = explore_settings(campus, AvatarProfile(), 60);
    RouteSettings settings;
    settings.strides = exploration.strides;
    settings.solids = exploration.solids;
    TrialWalk body(campus.world, settings.strides, settings.solids, {});
    const auto found = plan_route(campus.world, settings, {*body.put_down(from), {{"goal", to, true}}});
    return facts_of(std::get<Route>(found), campus.world, settings.strides.body, settings.solids);
}

TEST(RouteFacts, NamesTheDoorThatIsNarrowest) {
    scene::Campus campus = level_campus(10.0);
    add_box(campus, "left", {-10, 0, -0.1}, {-0.45, 2.5, 0.1});
    add_box(campus, "right", {0.45, 0, -0.1}, {10, 2.5, 0.1});
    add_box(campus, "post", {-0.9, 0, 4}, {-0.8, 2.5, 4.1});  // nothing on the other side
    const RouteFacts facts = facts_between(campus, {0, 0, 6}, {0, 0, -6});
    ASSERT_TRUE(facts.narrowest);
    EXPECT_NEAR(facts.narrowest->value, 0.9, 0.005);
    EXPECT_NEAR(facts.narrowest->at.z(), 0.0, 0.12);
    EXPECT_NEAR(facts.steepest.value, 0.0, 1e-3);
}

TEST(RouteFacts, OpenGroundHasNoNarrowestSpot) {
    const RouteFacts facts = facts_between(level_campus(10.0), {0, 0, 6}, {0, 0, -6});
    EXPECT_FALSE(facts.narrowest);
    EXPECT_NEAR(facts.steepest.at.z(), 6.0, 0.1) << "as level as everywhere else";
}

/// A floor of squares with sides of `side`, from -10 to 10 m.
void add_squares(collision::TriangleMesh& mesh, double side) {
    const int count = static_cast<int>(20.0 / side);
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) {
            const Vec3 at(-10.0 + side * i, 0.0, -10.0 + side * j);
            support::add_quad(mesh, at, at + Vec3(0, 0, side), at + Vec3(side, 0, side),
                              at + Vec3(side, 0, 0));
        }
    }
}

TEST(RouteFacts, AreThoseOfOpenGroundHoweverItsFloorIsDivided) {
    for (const double side : {10.0, 2.0, 1.0, 0.5, 0.125}) {
        scene::Campus campus = empty_campus();
        collision::TriangleMesh mesh;
        add_squares(mesh, side);
        support::add_box(mesh, {0.9, 0, -0.5}, {1.1, 0.15, 0.5});  // a kerb that one steps on
        add_object(campus, "ground", std::make_shared<const collision::MeshCollider>(std::move(mesh)),
                   Vec3::Zero());
        EXPECT_FALSE(facts_between(campus, {0, 0, 6}, {0, 0, -6}).narrowest) << side;
        add_box(campus, "left", {-3, 0, -0.1}, {-0.8, 2.5, 0.1});
        add_box(campus, "right", {0.7, 0.9, -0.1}, {3, 1.0, 0.1});  // a table's top
        const RouteFacts facts = facts_between(campus, {0, 0, 6}, {0, 0, -6});
        ASSERT_TRUE(facts.narrowest) << side;
        EXPECT_NEAR(facts.narrowest->value, 1.5, 0.005) << side;
    }
}

TEST(RouteFacts, NamesTheSteepestRamp) {
    scene::Campus campus = empty_campus();
    collision::TriangleMesh mesh;
    support::add_floor(mesh, 10.0);
    support::add_quad(mesh, {0, 0, -2}, {0, 0, 2}, {3, 1.2, 2}, {3, 1.2, -2});
    support::add_box(mesh, {3, 0, -2}, {6, 1.2, 2});
    add_object(campus, "ground", std::make_shared<const collision::MeshCollider>(std::move(mesh)),
               Vec3::Zero());
    const RouteFacts facts = facts_between(campus, {-4, 0, 0}, {5, 1.2, 0});
    EXPECT_NEAR(facts.steepest.value, std::atan2(1.2, 3.0), 1e-3);
    EXPECT_GT(facts.steepest.at.x(), -0.5);
    EXPECT_LT(facts.steepest.at.x(), 3.5);
}

}  // namespace
}  // namespace campuswalk::engine
