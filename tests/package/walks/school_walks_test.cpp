#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <cstdlib>
#include <filesystem>
#include <vector>

#include <doctest/doctest.h>

#include "collision/world/bullet_broad_phase.h"
#include "config/loader/load_run.h"
#include "engine/simulation/check_walk.h"
#include "engine/simulation/run_walk.h"
#include "engine/testing/event_log.h"
#include "scene/campus/campus.h"

using namespace campuswalk;

namespace {

/// A walk on its campus, ready to be played.
struct School {
    explicit School(const std::string& name)
        : run(config::load_run(std::filesystem::path(std::getenv("SCHOOL")) / "walks" / name,
                               config::SearchPaths{})),
          campus(scene::load_campus(*run.campus, collision::make_bullet_broad_phase(), warnings)) {}

    std::vector<scene::Diagnostic> warnings;
    config::Run run;
    scene::Campus campus;
};

}  // namespace

TEST_CASE("the visit passes and logs the expected events") {
    School school("visit.walk.yaml");
    REQUIRE(engine::check_walk(school.campus, school.run.walk).empty());
    engine::EventLog log;
    engine::Observer* observers[] = {&log};

    const engine::WalkSummary summary = engine::run_walk(school.campus, school.run.walk, observers);

    CHECK(summary.passed);
    CHECK(has_sequence(log.events(), {"trigger.enter library/door", "popup.open library", "walk.end"}));
    CHECK(has_never(log.events(), "collision.enter library/walls"));
    CHECK(count_of(log.events(), "popup.open") == 1);
}

TEST_CASE("a walk written in C++ ends at the wall") {
    School school("visit.walk.yaml");
    engine::Walk walk = school.run.walk;
    engine::WalkToStep through_the_wall;
    through_the_wall.target = {"behind-the-wall", {4.0, 0.0, -10.0}, true};
    walk.steps = {walk.steps.front(), through_the_wall};
    walk.expectations.clear();
    engine::EventLog log;
    engine::Observer* observers[] = {&log};

    const engine::WalkSummary summary = engine::run_walk(school.campus, walk, observers);

    CHECK(!summary.passed);
    CHECK(has_sequence(log.events(), {"collision.enter library/walls", "avatar.blocked"}));
}
