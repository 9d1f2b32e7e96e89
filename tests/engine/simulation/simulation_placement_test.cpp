// Spawns and teleports into solids: pushed out and logged, or rejected.

#include <gtest/gtest.h>

#include "engine/simulation/check_walk.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/support/penetration_oracle.h"

namespace campuswalk::engine {
namespace {

using Eigen::Vector3d;
using Lines = std::vector<std::string>;

/// A wall whose face is at x = 4, and a table 0.4 m high.
scene::Campus furnished_campus() {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {4, 0, -20}, {4.2, 3, 20});
    add_box(campus, "table", {-6, 0, -2}, {-4, 0.4, 2});
    return campus;
}

TEST(Placement, PushesATeleportOutOfAWallAndLogsIt) {
    const scene::Campus campus = furnished_campus();
    const Walk walk = walk_of({spawn_at({0, 0, 0}), teleport_to({3.8, 0, 1}, {}, "door"), wait_for(0.1)});
    EXPECT_TRUE(check_walk(campus, walk).empty());
    const RecordedRun result = run(campus, walk);
    EXPECT_EQ(result.recorder.event_lines(), Lines({"avatar.teleport door", "avatar.depenetrated door",
                                                    "collision.enter wall", "collision.exit wall"}));
    const Event push = result.recorder.events("avatar.depenetrated")[0];
    EXPECT_EQ(field<std::string>(push, "by"), "wall");
    EXPECT_EQ(field<Vector3d>(push, "from"), Vector3d(3.8, 0, 1));
    EXPECT_NEAR(field<Decimal>(push, "distance").value, 0.1, 0.002)
        << "0.1 m of the radius is inside the wall";
    const Vector3d foot = result.recorder.at(1).position;
    EXPECT_EQ(foot, field<Vector3d>(push, "pos"));
    EXPECT_LE(support::PenetrationOracle(campus.world).worst_penetration(foot, 0.3, 1.8).depth, 0.0);
}

TEST(Placement, LogsAPushOfTheFirstSpawnAfterTheWalksStart) {
    const RecordedRun result = run(furnished_campus(), walk_of({spawn_at({3.8, 0, 1}), wait_for(0.1)}));
    ASSERT_GE(result.recorder.events().size(), 2U);
    EXPECT_EQ(event_line(result.recorder.events()[0]), "walk.start stroll");
    EXPECT_EQ(event_line(result.recorder.events()[1]), "avatar.depenetrated start");
    EXPECT_LT(field<Vector3d>(result.recorder.events()[0], "pos").x(), 3.701);
}

TEST(Placement, LogsNothingForAFreeOrRoundedPlace) {
    for (const double y : {0.0, -0.001, -0.04, 0.3}) {
        const RecordedRun result = run(furnished_campus(), walk_of({spawn_at({0, y, 0}), wait_for(0.1)}));
        EXPECT_TRUE(result.recorder.events("avatar.depenetrated").empty()) << y;
    }
}

TEST(Placement, LiftsASpawnInATableOntoIt) {
    const RecordedRun result = run(furnished_campus(), walk_of({spawn_at({-5, 0, 0}), wait_for(0.1)}));
    EXPECT_NEAR(result.recorder.at(0).position.y(), 0.4, 1e-3);
    EXPECT_EQ(result.recorder.events("avatar.depenetrated start").size(), 1U);
}

TEST(Placement, UsesTheHeightOfACrouchedAvatar) {
    scene::Campus campus = level_campus();
    add_box(campus, "loft", {-20, 1.3, -20}, {20, 5, -10});
    const auto codes = [&](std::vector<Step> steps) {
        std::vector<std::string> found;
        for (const scene::Diagnostic& d : check_walk(campus, walk_of(std::move(steps)))) {
            found.emplace_back(d.code.text());
        }
        return found;
    };
    EXPECT_EQ(codes({spawn_at({0, 0, 0}), teleport_to({0, 0, -15})}), Lines({"spawn-blocked"}));
    EXPECT_EQ(codes({spawn_at({0, 0, 0}), set_height(1.2), teleport_to({0, 0, -15})}), Lines());
    EXPECT_EQ(codes({spawn_at({0, 0, 0}), set_height(1.2), set_height(1.8), teleport_to({0, 0, -15})}),
              Lines({"spawn-blocked"}));
}

TEST(Placement, IgnoresObjectsThatAreDisabledByThen) {
    const auto diagnostics = [&](std::vector<Step> steps) {
        return check_walk(furnished_campus(), walk_of(std::move(steps))).size();
    };
    EXPECT_EQ(diagnostics({spawn_at({0, 0, 0}), teleport_to({4.1, 0, 0})}), 1U);
    EXPECT_EQ(diagnostics({spawn_at({0, 0, 0}), disable("wall"), teleport_to({4.1, 0, 0})}), 0U);
    EXPECT_EQ(diagnostics({spawn_at({0, 0, 0}), disable("wall"), enable("w*"), teleport_to({4.1, 0, 0})}),
              1U);
}

}  // namespace
}  // namespace campuswalk::engine
