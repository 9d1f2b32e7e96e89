#include "engine/expect/body_evaluators.h"

#include <gtest/gtest.h>

#include "tests/engine/expect/single_evaluator.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine {
namespace {

const SourceMark kMark = {"a.walk.yaml", 7, 5};

// ---- no_penetration -------------------------------------------------------------------------------------

/// A floor, and a solid block whose side is at x = 2.
scene::Campus block_campus() {
    scene::Campus campus = level_campus();
    add_box(campus, "block", {2, 0, -1}, {4, 3, 1});
    return campus;
}

std::optional<Failure> inside_at(double x, double tolerance = 1e-4) {
    const scene::Campus campus = block_campus();
    SingleEvaluator evaluator(ExpectNoPenetration{kMark, tolerance}, campus);
    TickFeed(evaluator).tick({}, {0, 0.001, 0}).tick({}, {x, 0.001, 0}).tick({}, {0, 0.001, 0});
    return evaluator.failure();
}

TEST(NoPenetrationEvaluator, PassesOutsideOfSolids) {
    EXPECT_FALSE(inside_at(1.69));
    EXPECT_FALSE(inside_at(1.70005)) << "inside by less than the tolerance";
    EXPECT_FALSE(inside_at(1.75, 0.06));
}

TEST(NoPenetrationEvaluator, ReportsTheDeepestPenetration) {
    expect_failure(inside_at(1.75), 7, "no_penetration", {"50.00 mm", "block", "0.100 s", "0.10 mm"});
    EXPECT_EQ(inside_at(1.75)->scene.tick, 1);
    expect_failure(inside_at(3.0, 0.2), 7, "no_penetration", {"300.00 mm", "block", "0.100 s", "200.00 mm"});
}

TEST(NoPenetrationEvaluator, DetectsAnAvatarDeepInsideAMesh) {
    scene::Campus campus = empty_campus();
    collision::TriangleMesh mesh;
    support::add_box(mesh, {-5, -5, -5}, {5, 5, 5});
    add_object(campus, "hill", std::make_shared<const collision::MeshCollider>(std::move(mesh)),
               Eigen::Vector3d::Zero());
    SingleEvaluator evaluator(ExpectNoPenetration{kMark, 1e-4}, campus);
    TickFeed(evaluator).tick({}, {0, -1, 0});
    expect_failure(evaluator.failure(), 7, "no_penetration", {"300.00 mm", "hill", "0.000 s", "0.10 mm"});
}

TEST(NoPenetrationEvaluator, IgnoresDisabledObjects) {
    const scene::Campus campus = block_campus();
    SingleEvaluator evaluator(ExpectNoPenetration{kMark, 1e-4}, campus);
    const std::vector<bool> disabled = {false, true};
    TickRecord record;
    record.avatar.position = {3, 0.001, 0};
    record.disabled = &disabled;
    evaluator.on_tick(record);
    EXPECT_FALSE(evaluator.failure());
}

// ---- grounded -------------------------------------------------------------------------------------------

/// One of four ticks is in the air; the walk's closing record repeats its last tick.
std::optional<Failure> hop(double ratio) {
    SingleEvaluator evaluator(ExpectGrounded{kMark, ratio});
    TickRecord record;
    for (const Tick tick : {0, 1, 2, 3, 3}) {
        record.tick = tick;
        record.time = 0.1 * static_cast<double>(tick);
        record.avatar.grounded = tick != 3;
        evaluator.on_tick(record);
    }
    return evaluator.failure();
}

TEST(GroundedEvaluator, CountsTicksOffTheGround) {
    EXPECT_FALSE(hop(0.75));
    expect_failure(hop(0.76), 7, "grounded", {"1 of 4 ticks", "0.300 s", "24.0 %"});
    expect_failure(hop(1.0), 7, "grounded", {"1 of 4 ticks", "0.300 s", " 0.0 %"});
}

// ---- blocked_by and stuck -------------------------------------------------------------------------------

template <typename Expected>
std::optional<Failure> bumped(const Expected& expected) {
    SingleEvaluator evaluator(expected);
    TickFeed(evaluator)
        .tick({"collision.enter lamp"})
        .with({made_event("avatar.stuck me", {{"by", std::string("bench/1")}})}, {0, 0, 0})
        .with({made_event("avatar.blocked goal", {{"by", std::string("wall")}})}, {0, 0, 0});
    return evaluator.failure();
}

TEST(BlockedByEvaluator, PassesForTheObjectsThatBlocked) {
    EXPECT_FALSE(bumped(ExpectBlockedBy{kMark, {kMark, "wall"}}));
    EXPECT_FALSE(bumped(ExpectBlockedBy{kMark, {kMark, "bench/*"}})) << "stuck is blocked too";
    expect_failure(bumped(ExpectBlockedBy{kMark, {kMark, "lamp"}}), 7, "blocked_by",
                   {"'lamp'", "wall at 0.200 s"});
}

TEST(BlockedByEvaluator, FailsIfNothingBlocked) {
    SingleEvaluator evaluator(ExpectBlockedBy{kMark, {kMark, "lamp"}});
    TickFeed(evaluator).tick({"collision.enter lamp", "avatar.arrive goal"});
    expect_failure(evaluator.failure(), 7, "blocked_by", {"'lamp'"});
    EXPECT_EQ(evaluator.failure()->message.find("but"), std::string::npos);
}

TEST(BlockedByEvaluator, SaysWhyAsTheEventDoes) {
    const Reason why{.kind = ReasonKind::riser,
                     .object = "world",
                     .node = "stage",
                     .at = Eigen::Vector3d(1, 0.45, -4),
                     .measured = 0.45,
                     .allowed = 0.3};
    const std::string words = "riser of 0.45 m at world (stage), 1.00, 0.45, -4.00; the avatar steps 0.30 m";
    const std::vector<Event> blocked{made_event(
        "avatar.blocked goal", {{"by", std::string("world")}, {"why", std::make_shared<const Reason>(why)}})};
    SingleEvaluator expected(ExpectBlockedBy{kMark, {kMark, "lamp"}});
    TickFeed(expected).with(blocked, {0, 0, 0});
    expect_failure(expected.failure(), 7, "blocked_by", {"'lamp'", "world at 0.000 s: " + words});
    EXPECT_EQ(expected.failure()->reason, why);
    SingleEvaluator unexpected(ExpectNot{kMark, ExpectBlockedBy{kMark, {kMark, "world"}}});
    TickFeed(unexpected).with(blocked, {0, 0, 0});
    expect_failure(unexpected.failure(), 7, "not-blocked_by", {"blocked by world at 0.000 s: " + words});
    EXPECT_EQ(unexpected.failure()->reason, why);
}

TEST(StuckEvaluator, RequiresAnEventWithTheObject) {
    EXPECT_FALSE(bumped(ExpectStuck{kMark, {kMark, "*"}}));
    EXPECT_FALSE(bumped(ExpectStuck{kMark, {kMark, "bench/?"}}));
    expect_failure(bumped(ExpectStuck{kMark, {kMark, "wall"}}), 7, "stuck", {"'wall'", "bench/1 at 0.100 s"});
    SingleEvaluator evaluator(ExpectStuck{kMark, {kMark, "*"}});
    TickFeed(evaluator).tick({"avatar.blocked goal"});
    expect_failure(evaluator.failure(), 7, "stuck", {});
    EXPECT_EQ(evaluator.failure()->message.find("by '"), std::string::npos)
        << "the wildcard isn't worth a mention";
}

TEST(StuckEvaluator, MatchesOnlyTheWildcardIfTheObstacleIsUnknown) {
    SingleEvaluator anything(ExpectStuck{kMark, {kMark, "*"}});
    SingleEvaluator lamp(ExpectStuck{kMark, {kMark, "lamp"}});
    TickFeed(anything).tick({"avatar.stuck me"});
    TickFeed(lamp).tick({"avatar.stuck me"});
    EXPECT_FALSE(anything.failure());
    expect_failure(lamp.failure(), 7, "stuck", {"'lamp'", "0.000 s"});
}

// ---- fell -----------------------------------------------------------------------------------------------

TEST(FellEvaluator, RequiresTheEvent) {
    SingleEvaluator evaluator(ExpectFell{kMark});
    TickFeed feed(evaluator);
    feed.tick({"avatar.landed me"});
    expect_failure(evaluator.failure(), 7, "fell", {"not fall"});
    feed.tick({"avatar.fell me"});
    EXPECT_FALSE(evaluator.failure());
}

}  // namespace
}  // namespace campuswalk::engine
