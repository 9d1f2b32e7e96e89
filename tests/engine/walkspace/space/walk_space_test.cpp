// Chains of strides, replayed by the strider and, independently, by the simulation.

#include "engine/walkspace/space/walk_space.h"

#include <filesystem>
#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "collision/world/bullet_broad_phase.h"
#include "engine/simulation/simulation.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/walkspace/explore/explored_ground.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine {
namespace {

using collision::Vec3;

/// For one tick: what the body should do in it, and where that should bring it.
struct PlannedTick {
    Stride stride;
    bool first = false;  ///< of its stride
    Vec3 foot = Vec3::Zero();
};

/// Of a second, at 60 a second.
constexpr int kTicksOfAFifth = 12;

/// Plays strides by what their description says, without knowing how the strider does it.
class PlannedStrides final : public IntentSource {
public:
    PlannedStrides(const Vec3& start, const StrideSettings& strides, const std::vector<PlannedTick>& plan)
        : start_(start), strides_(strides), plan_(plan) {}

    Intent intend(const AvatarState& avatar) override {
        Intent intent;
        if (!placed_) {
            placed_ = true;
            intent.placement = Intent::Placement{&label_, start_, EventKind::avatar_spawn};
            return intent;
        }
        const PlannedTick& tick = plan_[next_++];
        const Stride& stride = tick.stride;
        std::uint8_t direction = stride.direction;
        const bool takes_off = tick.first && stride.gait == Gait::jump;
        if (takes_off) {
            intent.jump = strides_.jump_speed;
        }
        ticks_in_air_ = tick.first ? 0 : ticks_in_air_;
        if (takes_off || !avatar.grounded) {
            const bool steers = ++ticks_in_air_ > kTicksOfAFifth * stride.steers_after;
            direction = steers && stride.steering != Stride::kStraightOn ? stride.steering : direction;
        }
        if (direction != Stride::kLetGo) {
            const double speed = stride.gait == Gait::walk ? strides_.walk_speed : strides_.run_speed;
            intent.move = speed * strides_.seconds * grid_directions()[direction].unit;
        }
        return intent;
    }
    bool finished() const override { return placed_ && next_ == plan_.size(); }

private:
    std::string label_ = "start";
    Vec3 start_;
    StrideSettings strides_;
    const std::vector<PlannedTick>& plan_;
    std::size_t next_ = 0;
    bool placed_ = false;
    int ticks_in_air_ = 0;
};

/// The ticks of a chain, from the fall to the ground on.
std::vector<PlannedTick> plan_of(const std::vector<ChainLink>& chain, const WalkSpace& space,
                                 const Vec3& start, Strider& strider) {
    std::vector<PlannedTick> plan;
    EXPECT_EQ(strider.put_down(start).at, chain.front().at);
    for (const Vec3& foot : strider.path()) {
        plan.push_back({{.steering = Stride::kLetGo}, false, foot});
    }
    for (std::size_t i = 1; i < chain.size(); ++i) {
        const Stride& stride = chain[i].stride;
        strider.take(chain[i - 1].at, stride, space.grid);
        bool first = true;
        for (const Vec3& foot : strider.path()) {
            plan.push_back({stride, std::exchange(first, false), foot});
        }
    }
    return plan;
}

/// Ticks that end elsewhere than the plan says, in the last bit.
std::size_t differing_ticks(const scene::Campus& campus, const ExploreSettings& settings,
                            const std::vector<PlannedTick>& plan) {
    PlannedStrides strides(settings.starts.front(), settings.strides, plan);
    const Walk walk = walk_of({});
    Simulation simulation(campus, walk, strides);
    simulation.step();
    std::size_t differing = 0;
    for (const PlannedTick& tick : plan) {
        differing += simulation.step().avatar.position == tick.foot ? 0U : 1U;
    }
    return differing;
}

/// Each chain ends in its node's cell and level, in a state that can be found from the nearest keyframe too.
void expect_chains_lead_to(const std::vector<WalkNodeId>& nodes, const WalkSpace& space,
                           const scene::Campus& campus, const ExploreSettings& settings) {
    for (const WalkNodeId& node : nodes) {
        Strider fresh(campus.world, settings.strides, settings.solids);
        const GroundState end = space.chain(node, fresh).back().at;
        EXPECT_EQ(space.grid.cell_at(end.foot), space.cell_of(node));
        EXPECT_EQ(static_cast<float>(end.foot.y()), space.node(node).y);
        Strider another(campus.world, settings.strides, settings.solids);
        EXPECT_EQ(space.state_at(node, another), end);
    }
}

void expect_simulation_agrees(const std::vector<WalkNodeId>& nodes, const WalkSpace& space,
                              const scene::Campus& campus, const ExploreSettings& settings) {
    for (const WalkNodeId& node : nodes) {
        Strider strider(campus.world, settings.strides, settings.solids);
        const std::vector<PlannedTick> plan =
            plan_of(space.chain(node, strider), space, settings.starts.front(), strider);
        EXPECT_EQ(differing_ticks(campus, settings, plan), 0U)
            << "to " << space.position(node).transpose() << " in " << plan.size() << " ticks";
    }
}

/// Nodes that only a stride with this property leads to.
template <typename Property>
std::vector<WalkNodeId> nodes_with(const WalkSpace& space, const Property& property) {
    std::vector<WalkNodeId> found;
    for (const WalkNodeId& node : nodes_of(space)) {
        if (space.parent(node) && property(space.node(node).stride())) {
            found.push_back(node);
        }
    }
    return found;
}

TEST(Chains, LeadToTheirNodes) {
    const scene::Campus campus = varied_ground();
    const ExploreSettings settings = explore_from(kOnVariedGround);
    const WalkSpace space = explored(campus.world, settings);
    ASSERT_GT(space.node_count(), 6000U);
    expect_chains_lead_to(some_nodes(space, 500), space, campus, settings);
}

TEST(Chains, AreWalksOfTheSimulation) {
    const scene::Campus campus = varied_ground();
    const ExploreSettings settings = explore_from(kOnVariedGround);
    const WalkSpace space = explored(campus.world, settings);
    expect_simulation_agrees(some_nodes(space, 40), space, campus, settings);
}

TEST(Chains, StartWithTheFallOfTheSpawn) {
    const scene::Campus campus = varied_ground();
    for (const double above : {0.0, 0.7, 3.0}) {
        const ExploreSettings settings = explore_from({-6.5, 0.9 + above, 4.5});
        const WalkSpace space = explored(campus.world, settings);
        ASSERT_FALSE(space.starts.empty());
        EXPECT_NEAR(space.position(space.starts.front()).y(), 0.9, 0.01);
        expect_simulation_agrees(some_nodes(space, 10), space, campus, settings);
    }
}

TEST(Chains, OfSteeredFallsRunsAndJumpsAreWalksOfTheSimulation) {
    const scene::Campus campus = varied_ground();
    ExploreSettings settings = explore_from(kOnVariedGround);
    settings.run = true;
    settings.jump = true;
    const WalkSpace space = explored(campus.world, settings);
    for (const Gait gait : {Gait::run, Gait::jump}) {
        const auto nodes = nodes_with(space, [&](const Stride& stride) { return stride.gait == gait; });
        EXPECT_FALSE(gait == Gait::jump && nodes.empty()) << "the ledge of 0.9 m is jumped onto or off";
        expect_simulation_agrees(nodes, space, campus, settings);
        expect_chains_lead_to(nodes, space, campus, settings);
    }
    const auto steered =
        nodes_with(space, [](const Stride& stride) { return stride.steering != Stride::kStraightOn; });
    expect_simulation_agrees(steered, space, campus, settings);
    expect_chains_lead_to(steered, space, campus, settings);
}

TEST(Chains, ReachOverSeveralTiles) {
    // A run off a tower of 80 m lands 11 m away, beyond the tiles around.
    collision::TriangleMesh mesh;
    support::add_floor(mesh, 20.0);
    support::add_box(mesh, {-2, 0, -2}, {2, 80, 2});
    const scene::Campus campus = campus_of(std::move(mesh));
    ExploreSettings settings = explore_from({0, 80, 0});
    settings.run = true;
    const WalkSpace space = explored(campus.world, settings);
    std::vector<WalkNodeId> far;
    for (const WalkNodeId& node : nodes_of(space)) {
        if (space.node(node).parent_tile == WalkNode::kFarParent) {
            far.push_back(node);
        }
    }
    EXPECT_GT(far.size(), 2U);
    expect_chains_lead_to(far, space, campus, settings);
    expect_simulation_agrees(far, space, campus, settings);
}

/// recastnavigation's test level; none where the shared data are missing.
std::unique_ptr<scene::Campus> dungeon() {
    const auto model =
        std::filesystem::path(CAMPUSWALK_SOURCE_DIR) / ".." / "shared" / "data" / "recast" / "dungeon.obj";
    if (!std::filesystem::exists(model)) {
        return nullptr;
    }
    scene::CampusDescription description;
    description.name = "dungeon";
    description.scenes.emplace_back().path = model;
    scene::ColliderDescription& collider = description.colliders.emplace_back();
    collider.id = "dungeon";
    collider.nodes = {{{}, "*"}};
    collider.modes.solid = true;
    std::vector<scene::Diagnostic> warnings;
    return std::make_unique<scene::Campus>(
        scene::load_campus(std::move(description), collision::make_bullet_broad_phase(), warnings));
}

TEST(Chains, ReplayInADungeon) {
    const auto campus = dungeon();
    if (!campus) {
        GTEST_SKIP() << "no model at ../shared/data/recast/dungeon.obj";
    }
    AvatarProfile avatar;
    avatar.step_height = 0.4;
    const ExploreSettings settings = explore_from({40, 10.1, 0}, avatar);
    const WalkSpace space = explored(campus->world, settings, 2);
    EXPECT_GT(space.area(), 1500.0);
    EXPECT_TRUE(space.find(space.grid.cell_at({19.8, 18.83, -79.7}), 18.83, 0.3)) << "the upper hall";
    // Only along a rising edge, on which the body hangs above the floor beside it: random walks found it.
    EXPECT_TRUE(space.find(space.grid.cell_at({18.9, 15.6, -86.18}), 15.6, 0.1)) << "a ledge at a wall";
    expect_chains_lead_to(some_nodes(space, 500), space, *campus, settings);
}

TEST(Strider, StandsInAWedge) {
    const auto campus = dungeon();
    if (campus == nullptr) {
        GTEST_SKIP() << "no model at ../shared/data/recast/dungeon.obj";
    }
    AvatarProfile avatar;
    avatar.step_height = 0.4;
    Strider strider(campus->world, strides_of(avatar), {});
    // Between the rock and a wall, both too steep to stand on.
    const StrideEnd above = strider.put_down({15.8647, 16.6341, -74.8572});
    const StrideEnd end = strider.take(above.at, {.direction = 2}, WalkGrid{});
    EXPECT_EQ(end.kind, StrideEnd::Kind::grounded);
    EXPECT_LT(end.ticks, 120);
}

TEST(Strider, FallsByLongTicks) {
    const scene::Campus campus = varied_ground();
    for (const double seconds : {0.5, 1.0}) {  // a fall over its rim
        StrideSettings settings = strides_of();
        settings.seconds = seconds;
        Strider strider(campus.world, settings, {});
        StrideEnd end = strider.put_down({9.0, 0, 9.0});
        for (int i = 0; i < 20 && end.kind == StrideEnd::Kind::grounded; ++i) {
            end = strider.take(end.at, {.direction = 0}, WalkGrid{});
        }
        EXPECT_EQ(end.kind, StrideEnd::Kind::gone);
    }
}

}  // namespace
}  // namespace campuswalk::engine
