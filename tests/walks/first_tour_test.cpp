// The demo tour: what its log says, and that its avatar is never inside anything.

#include <algorithm>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/walks/audited_run.h"

namespace campuswalk::support {
namespace {

const std::filesystem::path kRoot = CAMPUSWALK_SOURCE_DIR;

/// The tour is run once for all tests.
const AuditedRun& tour() {
    static const AuditedRun run = audited_run(kRoot / "config" / "walks" / "first-tour.walk.yaml");
    return run;
}

std::vector<std::string> lines_of(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

/// The two words after the time: what happened, and to what.
std::pair<std::string, std::string> kind_and_object(const std::string& line) {
    std::istringstream words(line);
    std::string tick;
    std::string time;
    std::string kind;
    std::string object;
    words >> tick >> time >> kind >> object;
    return {kind, object};
}

std::set<std::string> objects_of(const std::string& kind) {
    std::set<std::string> objects;
    for (const std::string& line : tour().log) {
        const auto [each, object] = kind_and_object(line);
        if (each == kind) {
            objects.insert(object);
        }
    }
    return objects;
}

bool any_starts_with(const std::set<std::string>& names, const std::string& start) {
    return std::ranges::any_of(names, [&](const std::string& name) { return name.starts_with(start); });
}

TEST(FirstTour, PrintsItsGoldenLog) {
    const std::vector<std::string> golden = lines_of(kRoot / "tests" / "golden" / "first-tour.log");
    const std::vector<std::string>& log = tour().log;
    for (std::size_t i = 0; i < std::min(golden.size(), log.size()); ++i) {
        ASSERT_EQ(log[i], golden[i]) << "line " << i + 1;
    }
    EXPECT_EQ(log.size(), golden.size());
}

TEST(FirstTour, PassesAndLastsTwoMinutesWithoutTeleport) {
    EXPECT_TRUE(tour().summary.passed);
    EXPECT_GE(tour().summary.ticks, 120 * tour().walk.sim.ticks_per_second);
    EXPECT_TRUE(objects_of("avatar.teleport").empty());
}

TEST(FirstTour, NeverEndsATickInsideAnything) {
    EXPECT_EQ(tour().ticks, tour().summary.ticks + 1);
    expect_clean(tour());
}

TEST(FirstTour, EntersThreeBuildingsAndClimbsTheStairs) {
    const std::set<std::string> triggers = objects_of("trigger.enter");
    EXPECT_TRUE(triggers.contains("theatre/hall"));
    EXPECT_TRUE(triggers.contains("cafeteria/door"));
    EXPECT_TRUE(triggers.contains("library/door"));
    EXPECT_TRUE(triggers.contains("library/upper-floor"));
}

TEST(FirstTour, BumpsIntoAWallATreeABedAndABench) {
    const std::set<std::string> solids = objects_of("collision.enter");
    EXPECT_TRUE(any_starts_with(solids, "library/walls"));
    EXPECT_TRUE(any_starts_with(solids, "tree/"));
    EXPECT_TRUE(any_starts_with(solids, "flower-bed/"));
    EXPECT_TRUE(any_starts_with(solids, "bench/"));
    EXPECT_FALSE(objects_of("ray.enter").empty());
}

TEST(FirstTour, OpensFourPopUpsAndTakesFiveSnapshots) {
    EXPECT_GE(objects_of("popup.open").size(), 4U);
    EXPECT_EQ(objects_of("popup.open"), objects_of("popup.close"));
    EXPECT_GE(objects_of("snapshot.take").size(), 5U);
}

/// A mover that goes straight to each target, at its height, through whatever is in between.
TEST(FirstTour, AuditCatchesAMoverThatIgnoresWalls) {
    const AuditedRun& run = tour();
    const PenetrationOracle oracle(run.campus.world);
    TickAudit audit(oracle, run.walk.avatar);
    Point foot = std::get<engine::SpawnStep>(run.walk.steps.front()).position;
    engine::TickRecord record;
    for (const engine::Step& step : run.walk.steps) {
        const auto* walk_to = std::get_if<engine::WalkToStep>(&step);
        if (walk_to == nullptr) {
            continue;
        }
        const Point leg = walk_to->target.point - foot;
        const int ticks = static_cast<int>(leg.norm() / (run.walk.avatar.speed / 60.0)) + 1;
        for (int i = 1; i <= ticks; ++i) {
            record.avatar.position = foot + leg * (static_cast<double>(i) / ticks);
            record.time = static_cast<double>(record.tick) / 60.0;
            audit.on_tick(record);
            ++record.tick;
        }
        foot = walk_to->target.point;
    }
    const auto through = [](const std::string& diagnostic) {
        return diagnostic.find("through object") != std::string::npos;
    };
    EXPECT_GT(std::ranges::count_if(audit.diagnostics(), through), 0);
    EXPECT_GT(std::ranges::count_if(audit.diagnostics(), std::not_fn(through)), 100);
}

}  // namespace
}  // namespace campuswalk::support
