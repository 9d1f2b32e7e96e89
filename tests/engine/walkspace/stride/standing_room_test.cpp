// Where nobody can stand, wherever they come from: no exploration is needed to tell.

#include "engine/walkspace/stride/standing_room.h"

#include <variant>

#include <gtest/gtest.h>

#include "engine/walkspace/route/route.h"
#include "engine/walkspace/stride/trial_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/engine/walkspace/explore/explored_ground.h"

namespace campuswalk::engine {
namespace {

using collision::Vec3;

class StandingRoom : public testing::Test {
protected:
    StandingRoom() {
        add_box(campus_, "block", {-1, 0, -1}, {1, 3, 1});
        add_box(campus_, "table", {4, 0.7, -1}, {6, 0.8, 1});
    }
    bool may_stand(const Vec3& at, double within = 0.05) const {
        return may_stand_at(campus_.world, {}, strides_of().body, {"goal", at, true}, within);
    }

    scene::Campus campus_ = level_campus(10.0);
};

TEST_F(StandingRoom, ThereIsNoneInABlock) {
    EXPECT_FALSE(may_stand({0, 0, 0}));
    EXPECT_TRUE(may_stand({1.4, 0, 0})) << "beside it";
    EXPECT_TRUE(may_stand({0, 3, 0})) << "on top of it";
}

TEST_F(StandingRoom, ATargetMayBeReachedFromBesideIt) {
    EXPECT_TRUE(may_stand({0.9, 0, 0}, 0.5)) << "one arrives 0.4 m beside it";
    EXPECT_FALSE(may_stand({0.0, 0, 0}, 0.5));
}

TEST_F(StandingRoom, ThereIsNoneInTheAirOrBesideTheWorld) {
    EXPECT_FALSE(may_stand({0, 6, 5}));
    EXPECT_FALSE(may_stand({12, 0, 0}));
    EXPECT_TRUE(may_stand({0, 0.4, 5})) << "the ground is near enough";
}

/// What it says is so certain that it never contradicts a walk.
TEST(StandingRoomOnVariedGround, EveryPlaceThatIsReachedHasSome) {
    const scene::Campus campus = varied_ground();
    const WalkSpace space = explored(campus, kOnVariedGround);
    const double half_cell_diagonal = 0.18;
    std::size_t hanging = 0;
    for (const WalkNodeId& node : some_nodes(space, 5000)) {
        const Vec3 foot = space.position(node);
        hanging += space.node(node).hangs;
        EXPECT_TRUE(may_stand_at(campus.world, {}, strides_of().body, {"", foot, true}, half_cell_diagonal))
            << foot.transpose();
    }
    EXPECT_GT(hanging, 10U) << "bodies over the edges of the ground are among them";
}

TEST_F(StandingRoom, ARouteToSuchAPlaceIsGivenUpBeforeTheCampusIsExplored) {
    const RouteSettings settings{.strides = strides_of(), .solids = {}};
    TrialWalk body(campus_.world, settings.strides, settings.solids, {});
    const RouteRequest request{*body.put_down({5, 0, 5}), {{"goal", {0, 0, 0}, true}}};
    const auto found = plan_route(campus_.world, settings, request);
    ASSERT_TRUE(std::holds_alternative<NoRoute>(found));
    EXPECT_TRUE(std::get<NoRoute>(found).no_room);
    EXPECT_EQ(std::get<NoRoute>(found).reached.strides, 0U);
}

}  // namespace
}  // namespace campuswalk::engine
