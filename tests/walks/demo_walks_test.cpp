// The other walks of the demo campus: each passes its own expectations; together they use every kind of step.

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/walks/audited_run.h"

namespace campuswalk::support {
namespace {

AuditedRun run_of(const std::string& name) {
    return audited_run(std::filesystem::path(CAMPUSWALK_SOURCE_DIR) / "config" / "walks" /
                       (name + ".walk.yaml"));
}

/// A run that passes and is never inside anything or passes through it.
AuditedRun clean_run_of(const std::string& name) {
    AuditedRun run = run_of(name);
    expect_passed(run);
    expect_clean(run);
    return run;
}

std::size_t lines_with(const AuditedRun& run, const std::string& words) {
    return static_cast<std::size_t>(std::ranges::count_if(
        run.log, [&](const std::string& line) { return line.find(words) != std::string::npos; }));
}

TEST(DemoWalks, UseEveryKindOfStep) {
    const AuditedRun run = run_of("every-step");
    expect_passed(run);
    std::set<std::size_t> kinds;
    for (const engine::Step& step : run.walk.steps) {
        kinds.insert(step.index());
    }
    EXPECT_EQ(kinds.size(), std::variant_size_v<engine::Step>);
    // It walks through the fountain while that is disabled, and through nothing else.
    for (const std::string& diagnostic : run.diagnostics) {
        const bool in_fountain =
            std::ranges::any_of(std::vector<std::string>{"fountain", "fountain/jet"}, [&](const auto& id) {
                const auto object = std::ranges::find(run.campus.objects, id, &scene::CampusObject::id);
                return diagnostic.ends_with("object " + std::to_string(object - run.campus.objects.begin()));
            });
        EXPECT_TRUE(in_fountain) << diagnostic;
    }
    EXPECT_FALSE(run.diagnostics.empty()) << "it does walk through the fountain";
}

// The same path for three bodies: a sign with its board 1.25 m above the ground, then steps of 17 cm.

TEST(DemoWalks, AnAdultDucksUnderASignAndClimbsSteps) {
    const AuditedRun run = clean_run_of("adult-visit");
    EXPECT_EQ(lines_with(run, "avatar.blocked   library-sign-north"), 1U);
    EXPECT_EQ(lines_with(run, "avatar.blocked   library-portico"), 0U);
}

TEST(DemoWalks, AChildPassesUnderWhatStopsAnAdult) {
    const AuditedRun run = clean_run_of("child-visit");
    EXPECT_EQ(lines_with(run, "avatar.blocked"), 0U);
    EXPECT_EQ(lines_with(run, "avatar.crouch"), 0U);
}

TEST(DemoWalks, ARobotStopsAtStepsAndTakesTheRamp) {
    const AuditedRun run = clean_run_of("robot-delivery");
    EXPECT_EQ(lines_with(run, "avatar.blocked   library-sign-north"), 0U);
    EXPECT_EQ(lines_with(run, "avatar.blocked   library-portico"), 1U);
    EXPECT_EQ(lines_with(run, "avatar.arrive    library-ramp-top"), 1U);
}

}  // namespace
}  // namespace campuswalk::support
