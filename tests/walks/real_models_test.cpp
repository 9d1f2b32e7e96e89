// Walks over third-party models: each passes its own expectations, goes far, and is never inside anything.

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "tests/walks/audited_run.h"

namespace campuswalk::support {
namespace {

namespace fs = std::filesystem;

struct RealWalk {
    std::string name;
    std::string model;      ///< below the shared data
    double climb = 0.0;     ///< least metres from its start up to its end; negative: it may end below
    double distance = 0.0;  ///< least metres from its start to its end in a straight line
};

void PrintTo(const RealWalk& walk, std::ostream* out) {
    *out << walk.name;
}

class RealModels : public testing::TestWithParam<RealWalk> {};

TEST_P(RealModels, ReachesAFarGoal) {
    const RealWalk& expected = GetParam();
    const fs::path model = fs::path(CAMPUSWALK_SOURCE_DIR) / ".." / "shared" / "data" / expected.model;
    if (!fs::exists(model)) {
        GTEST_SKIP() << "no model at ../shared/data/" << expected.model;
    }
    const AuditedRun run =
        audited_run(fs::path(CAMPUSWALK_SOURCE_DIR) / "tests" / "walks" / (expected.name + ".walk.yaml"));

    expect_passed(run);
    EXPECT_GE(run.summary.ticks, 30 * run.walk.sim.ticks_per_second);
    expect_clean(run);

    const auto& spawn = std::get<engine::SpawnStep>(run.walk.steps.front());
    EXPECT_GE(run.end.y() - spawn.position.y(), expected.climb);
    EXPECT_GE((run.end - spawn.position).norm(), expected.distance);
    for (const engine::Step& step : run.walk.steps) {
        EXPECT_FALSE(std::holds_alternative<engine::TeleportStep>(step));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Walks, RealModels,
    testing::Values(RealWalk{"dungeon", "recast/dungeon.obj", 8.0, 80.0},
                    RealWalk{"parking-garage", "gazebo/parking_garage/meshes/parking_garage.dae", 6.0, 6.0},
                    RealWalk{"outdoor-campus", "ufaz/after153/outdoor_campus.obj", -0.5, 200.0},
                    RealWalk{"small-house", "small_house/small_house_visual.glb", -0.5, 9.0}),
    [](const testing::TestParamInfo<RealWalk>& walk) {
        std::string name = walk.param.name;
        std::ranges::replace(name, '-', '_');
        return name;
    });

}  // namespace
}  // namespace campuswalk::support
