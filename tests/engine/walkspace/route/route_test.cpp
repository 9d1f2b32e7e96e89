#include "engine/walkspace/route/route.h"
#include "engine/walkspace/explore/campus_settings.h"

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "collision/world/bullet_broad_phase.h"
#include "engine/script/avatar_body.h"
#include "engine/walkspace/report/walk_report.h"
#include "engine/walkspace/stride/trial_walk.h"
#include "scene/campus/campus.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/support/dice.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/village.h"

namespace campuswalk::engine {
namespace {

using collision::Vec3;

/// A campus to plan routes on.
struct Ground {
    explicit Ground(scene::Campus made, const AvatarProfile& profile = {})
        : campus(std::move(made)), avatar(profile) {
        const ExploreSettings exploration = explore_settings(campus, avatar, 60);
        settings.strides = exploration.strides;
        settings.solids = exploration.solids;
    }

    std::variant<Route, NoRoute> plan(const Vec3& from, const std::vector<Target>& to) const {
        TrialWalk body(campus.world, settings.strides, settings.solids, {});
        return plan_route(campus.world, settings, {*body.put_down(from), to});
    }
    Route route(const Vec3& from, const Vec3& to) const {
        auto found = plan(from, {{"goal", to, true}});
        EXPECT_TRUE(std::holds_alternative<Route>(found)) << from.transpose() << " to " << to.transpose();
        return std::holds_alternative<Route>(found) ? std::get<Route>(found) : Route();
    }
    RecordedRun play(const Vec3& from, const Target& to) const {
        GoToStep step;
        step.target = to;
        Walk walk = walk_of({spawn_at(from), step});
        walk.avatar = avatar;
        return run(campus, walk);
    }

    scene::Campus campus;
    AvatarProfile avatar;
    RouteSettings settings;
};

/// The pieces as steps; none if one of them isn't straight to a point.
std::optional<Walk> written(const Ground& ground, const Vec3& from, const Route& route) {
    std::vector<Step> steps{spawn_at(from)};
    for (const RoutePiece& piece : route.pieces) {
        if (piece.stride) {
            return std::nullopt;
        }
        WalkToStep step;
        step.target = piece.target;
        step.target.label = "point";
        step.within = piece.within;
        steps.emplace_back(step);
    }
    Walk walk = walk_of(std::move(steps));
    walk.avatar = ground.avatar;
    return walk;
}

/// Of the whole walk, tick by tick, to the last bit.
void expect_same_path(const RecordedRun& played, const Route& route) {
    EXPECT_TRUE(played.summary.passed);
    ASSERT_GE(played.recorder.states().size(), route.path.size());
    for (std::size_t i = 0; i < route.path.size(); ++i) {
        ASSERT_EQ(played.recorder.states()[i].avatar.position, route.path[i]) << "tick " << i;
    }
    EXPECT_EQ(played.summary.ticks, route.ticks());
}

Ground block() {
    scene::Campus campus = level_campus(20.0);
    add_box(campus, "block", {-5, 0, -5}, {5, 3, 5});
    return Ground(std::move(campus));
}

TEST(Route, GoesStraightWhereNothingObstructs) {
    const Ground ground(level_campus(20.0));
    const Route route = ground.route({-3, 0, 1}, {4, 0, 9});
    ASSERT_EQ(route.pieces.size(), 1U);
    EXPECT_NEAR(route.length(), std::hypot(7.0, 8.0), 0.06);
    EXPECT_LT(route.climb(), 0.001);
}

TEST(Route, RoundABlockIsHardlyLongerThanTheTautLine) {
    const Ground ground = block();
    const double radius = ground.avatar.radius;
    for (const double x : {-3.0, 0.0, 3.0}) {
        const Route route = ground.route({x, 0, 8}, {8, 0, x});
        // Around the corner at (5, 5): two tangents and an arc of the body's radius, here by a point.
        const Vec3 round(5.0 + radius * kDiagonal, 0, 5.0 + radius * kDiagonal);
        const double taut = (round - Vec3(x, 0, 8)).norm() + (round - Vec3(8, 0, x)).norm();
        EXPECT_GT(route.length(), taut - 0.15);
        EXPECT_LT(route.length(), 1.02 * taut) << x;
    }
}

/// As a visitor stands who walked into the wall: as near as the skin lets it, and a little farther off.
TEST(Route, AlongAWallThatItBeginsAtHasNoMorePiecesThanFromFartherOff) {
    scene::Campus campus = level_campus(20.0);
    add_box(campus, "wall", {-8.15, 0, -5}, {-7.85, 2, 5});
    const Ground ground(std::move(campus));
    const Vec3 goal(-12, 0, 0);
    const std::size_t pieces = ground.route({-7.0, 0, 0}, goal).pieces.size();
    for (const double gap : {0.0, 0.01, 0.02, 0.03, 0.05}) {
        const Route route = ground.route({-7.55 + gap, 0, 0}, goal);
        EXPECT_LE(route.pieces.size(), pieces + 1) << gap;
    }
}

TEST(Route, PlaysBitForBitAsAStepAndAsSteps) {
    const Ground ground = block();
    const Vec3 from(-8, 0, 7);
    const Vec3 to(8, 0, -7);
    const Route route = ground.route(from, to);
    EXPECT_GT(route.pieces.size(), 1U);
    expect_same_path(ground.play(from, {"goal", to, true}), route);
    const auto walk = written(ground, from, route);
    ASSERT_TRUE(walk);
    expect_same_path(run(ground.campus, *walk), route);
}

TEST(Route, IsTheSameEachTime) {
    const Ground ground = block();
    const Route first = ground.route({-8, 0, 7}, {8, 0, -7});
    const Route second = ground.route({-8, 0, 7}, {8, 0, -7});
    EXPECT_EQ(first.path, second.path);
}

TEST(Route, PassesTheTargetsBeforeTheLast) {
    const Ground ground = block();
    auto found = ground.plan({0, 0, 8}, {{"a", {-8, 0, 0}, true}, {"b", {0, 0, -8}, true}});
    ASSERT_TRUE(std::holds_alternative<Route>(found));
    bool passed = false;
    for (const Vec3& foot : std::get<Route>(found).path) {
        passed = passed || (foot - Vec3(-8, 0, 0)).norm() < 0.06;
    }
    EXPECT_TRUE(passed);
    EXPECT_LT((std::get<Route>(found).path.back() - Vec3(0, 0, -8)).norm(), 0.06);
}

TEST(Route, KeepsAwayFromWhatItIsTold) {
    Ground ground(level_campus(20.0));
    ground.settings.keep_out = [](const Vec3& foot) { return foot.norm() < 3.0; };
    const Route route = ground.route({-8, 0, 0}, {8, 0, 0});
    for (const Vec3& foot : route.path) {
        EXPECT_GE(foot.norm(), 3.0);
    }
    // Two tangents and an arc.
    const double taut = 2.0 * std::sqrt(64.0 - 9.0) + 3.0 * (M_PI - 2.0 * std::acos(3.0 / 8.0));
    EXPECT_GT(route.length(), taut - 0.1);
    EXPECT_LT(route.length(), 1.03 * taut);
}

TEST(Route, TakesTheStairsAndDoesNotLeapDown) {
    scene::Campus campus = empty_campus();
    collision::TriangleMesh mesh;
    support::add_floor(mesh, 12.0);
    support::add_stairs(mesh, -1.0, -4.0, 2.0, 0.16, 0.3, 10);
    add_object(campus, "ground", std::make_shared<const collision::MeshCollider>(std::move(mesh)),
               Vec3::Zero());
    const Ground ground(std::move(campus));
    const Route up = ground.route({0, 0, 6}, {2.5, 1.6, -3});
    EXPECT_NEAR(up.climb(), 1.6, 0.02);
    const Route down = ground.route({2.5, 1.6, -3}, {0, 0, 6});
    for (const Vec3& foot : down.path) {
        const bool beside = foot.z() > -1.7;
        EXPECT_TRUE(!beside || foot.y() < kHarmlessFall + 0.05) << foot.transpose();
    }
}

/// Routes between `count` random pairs of what is reached from `start`, each played as a step.
void expect_routes(const Ground& ground, const Vec3& start, int count) {
    const WorkerWorlds worlds(ground.campus.world, 1, {});
    ExploreSettings exploration;
    exploration.strides = ground.settings.strides;
    exploration.solids = ground.settings.solids;
    exploration.starts = {start};
    const WalkSpace space = explore(worlds, exploration);
    Strider strider(ground.campus.world, exploration.strides, exploration.solids);
    support::Dice dice(7);
    const auto some_node = [&] {
        int number = dice.below(static_cast<int>(space.node_count()));
        std::uint32_t tile = 0;
        while (number >= static_cast<int>(space.tiles[tile].nodes.size())) {
            number -= static_cast<int>(space.tiles[tile++].nodes.size());
        }
        return space.state_at({tile, static_cast<std::uint16_t>(number)}, strider);
    };
    int found = 0;
    int not_connected = 0;
    int strides = 0;
    for (int i = 0; i < count; ++i) {
        const GroundState from = some_node();
        const GroundState to = some_node();
        const Target goal{"goal", to.foot, true};
        auto route = plan_route(ground.campus.world, ground.settings, {state_of(from), {goal}});
        if (const auto* none = std::get_if<NoRoute>(&route)) {
            // One may not get back up: then the walk edges don't lead there either.
            EXPECT_GT(none->reached.node_count(), 0U);
            EXPECT_FALSE(none->reached.find(space.grid.cell_at(to.foot), to.foot.y(), 0.05))
                << from.foot.transpose() << " to " << to.foot.transpose();
            ++not_connected;
            continue;
        }
        ++found;
        const auto walk = written(ground, from.foot, std::get<Route>(route));
        strides += walk ? 0 : 1;
        const RecordedRun played = walk ? run(ground.campus, *walk) : ground.play(from.foot, goal);
        EXPECT_TRUE(played.summary.passed) << from.foot.transpose() << " to " << to.foot.transpose();
        EXPECT_TRUE(played.recorder.events("avatar.blocked").empty());
    }
    testing::Test::RecordProperty("found", found);
    testing::Test::RecordProperty("not_connected", not_connected);
    testing::Test::RecordProperty("with_strides", strides);
    EXPECT_GT(found, count / 2);
}

/// A floor with bottomless pits, between which one walks on ridges. To the terrace below one leaps farther
/// than guesses do, so that strides must be walked.
TEST(Route, LeadsWhereverWalkedEdgesDoBetweenPits) {
    scene::Campus campus = empty_campus();
    add_box(campus, "terrace", {7, -2, -7}, {12, -1, 7});
    for (int i = -6; i <= 6; i += 3) {
        const std::string name = std::to_string(i);
        add_box(campus, "row-" + name, {-7, -1, i - 0.6}, {7, 0, i + 0.6});
        add_box(campus, "column-" + name, {i - 0.6, -1, -7}, {i + 0.6, 0, 7});
    }
    const Ground ground(std::move(campus));
    expect_routes(ground, {0, 0, 0}, 60);
}

TEST(Route, DoesNotDependOnTheGroundThatIsKnown) {
    Ground ground = block();
    const std::vector<std::pair<Vec3, Vec3>> pairs{
        {{-8, 0, 7}, {8, 0, -7}}, {{0, 0, 8}, {8, 0, 0}}, {{-8, 0, -7}, {8, 0, 7}}};
    std::vector<std::vector<Vec3>> alone;
    alone.reserve(pairs.size());
    for (const auto& [from, to] : pairs) {
        alone.push_back(ground.route(from, to).path);
    }
    GroundMaps known;
    ground.settings.ground = &known;
    for (std::size_t round = 0; round < 2; ++round) {
        for (std::size_t i = pairs.size(); i-- > 0;) {
            EXPECT_EQ(ground.route(pairs[i].first, pairs[i].second).path, alone[i]);
        }
    }
}

TEST(Route, LeadsWhereverWalkedEdgesDoInAVillage) {
    scene::Campus campus{{}, {}, {}, std::move(*support::make_village())};
    for (std::size_t i = 0; i < campus.world.size(); ++i) {
        campus.objects.emplace_back().id = "object-" + std::to_string(i);
    }
    const Ground ground(std::move(campus));
    expect_routes(ground, {0, 1, 0}, 100);
}

TEST(Route, LeadsWhereverWalkedEdgesDoInADungeon) {
    const auto model =
        std::filesystem::path(CAMPUSWALK_SOURCE_DIR) / ".." / "shared" / "data" / "recast" / "dungeon.obj";
    if (!std::filesystem::exists(model)) {
        GTEST_SKIP() << "no model at ../shared/data/recast/dungeon.obj";
    }
    scene::CampusDescription description;
    description.name = "dungeon";
    description.scenes.emplace_back().path = model;
    scene::ColliderDescription& collider = description.colliders.emplace_back();
    collider.id = "dungeon";
    collider.nodes = {{{}, "*"}};
    collider.modes.solid = true;
    std::vector<scene::Diagnostic> warnings;
    AvatarProfile avatar;
    avatar.step_height = 0.4;
    const Ground ground(
        scene::load_campus(std::move(description), collision::make_bullet_broad_phase(), warnings), avatar);
    expect_routes(ground, {40, 10.1, 0}, 8);  // seconds each
}

}  // namespace
}  // namespace campuswalk::engine
