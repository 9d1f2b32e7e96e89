#include "engine/observers/cost_trace.h"

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

using Json = nlohmann::json;

struct Traced {
    std::string text;
    WalkSummary summary;
};

Traced traced(CostTrace::Clock clock = {}, collision::TreeKind tree = collision::TreeKind::bvh8) {
    scene::Campus campus = level_campus(50.0, tree);
    add_box(campus, "gate \"north\"", {-1, 0, -4}, {1, 2, -3}, {collision::Detection::trigger, "", true, ""});
    Walk walk = walk_of({spawn_at({0, 0, 0}), walk_to(0.0, -6.0)});
    walk.sim.tree = tree;
    Traced traced;
    CostTrace trace([&](std::string_view line) { (traced.text += line) += '\n'; }, std::move(clock));
    const std::array<Observer*, 1> observers = {&trace};
    traced.summary = run_walk(campus, walk, observers);
    return traced;
}

std::vector<Json> slices(const Json& trace, const std::string& name, int track) {
    std::vector<Json> found;
    for (const Json& event : trace.at("traceEvents")) {
        if (event.at("ph") == "X" && event.at("name") == name && event.at("tid") == track) {
            found.push_back(event);
        }
    }
    return found;
}

TEST(CostTrace, AddsUpToTheWalksQueryStatistics) {
    for (const collision::TreeKind tree : {collision::TreeKind::bvh8, collision::TreeKind::hybrid}) {
        const Traced all = traced({}, tree);
        const Json trace = Json::parse(all.text);
        const collision::QueryStatistics& counted = all.summary.statistics;
        const auto sum = [&](const char* name) {
            std::uint64_t total = 0;
            for (const std::string stage : {"move", "sense"}) {
                for (const Json& slice : slices(trace, stage, 1)) {
                    total += slice.at("args").at(name).get<std::uint64_t>();
                }
            }
            return total;
        };
        EXPECT_GT(counted.box_tests, 0U);
        EXPECT_EQ(sum("sphere_tests"), counted.sphere_tests);
        EXPECT_EQ(sum("box_tests"), counted.box_tests);
        EXPECT_EQ(sum("triangle_tests"), counted.primitive_tests);
        EXPECT_EQ(sum("transform_updates"), counted.transform_updates);
    }
}

TEST(CostTrace, EndsWithTheTermsOfEquation4AndTheDecisionsByEquation1) {
    const Traced hybrid = traced({}, collision::TreeKind::hybrid);
    const Json terms = Json::parse(hybrid.text).at("otherData");
    const collision::QueryStatistics& counted = hybrid.summary.statistics;
    EXPECT_EQ(terms.at("tree"), "hybrid");
    EXPECT_EQ(terms.at("Nv"), counted.volume_tests);
    EXPECT_EQ(terms.at("Np"), counted.primitive_tests);
    EXPECT_EQ(terms.at("Nu"), counted.transform_updates);
    EXPECT_EQ(counted.sphere_tests, counted.volume_tests) << "the outer sphere of every node";
    EXPECT_EQ(terms.at("decided_by_eq_1"), counted.sphere_tests - counted.box_tests);
    EXPECT_FALSE(terms.contains("wall_time_us"));

    const Traced bvh8 = traced();
    const Json other = Json::parse(bvh8.text).at("otherData");
    EXPECT_EQ(other.at("tree"), "bvh8");
    EXPECT_EQ(other.at("Nv"),
              other.at("sphere_tests").get<std::uint64_t>() + other.at("box_tests").get<std::uint64_t>());
    EXPECT_EQ(bvh8.summary.hash, hybrid.summary.hash);
}

TEST(CostTrace, NestsConsecutiveStagesInTicks) {
    const Traced all = traced();
    const Json trace = Json::parse(all.text);
    const std::vector<Json> ticks = slices(trace, "tick", 1);
    const std::vector<Json> moves = slices(trace, "move", 1);
    const std::vector<Json> detections = slices(trace, "sense", 1);
    ASSERT_EQ(ticks.size(), static_cast<std::size_t>(all.summary.ticks) + 1);
    ASSERT_EQ(moves.size(), ticks.size());
    ASSERT_EQ(detections.size(), ticks.size());
    const auto begin = [](const Json& slice) { return slice.at("ts").get<double>(); };
    const auto end = [&](const Json& slice) { return begin(slice) + slice.at("dur").get<double>(); };
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        EXPECT_EQ(ticks[i].at("args").at("tick"), i);
        EXPECT_EQ(begin(ticks[i]), i == 0 ? 0.0 : end(ticks[i - 1]));
        EXPECT_EQ(begin(moves[i]), begin(ticks[i]));
        EXPECT_EQ(begin(detections[i]), end(moves[i]));
        EXPECT_EQ(end(detections[i]) + 1.0, end(ticks[i]));
    }
}

TEST(CostTrace, MarksTheWalksEvents) {
    const Json trace = Json::parse(traced().text);
    std::vector<std::string> marks;
    for (const Json& event : trace.at("traceEvents")) {
        if (event.at("ph") == "i") {
            marks.push_back(event.at("name"));
        }
    }
    const std::vector<std::string> expected = {"walk.start stroll",           "trigger.enter gate \"north\"",
                                               "trigger.stay gate \"north\"", "trigger.exit gate \"north\"",
                                               "avatar.arrive goal",          "walk.end stroll"};
    EXPECT_EQ(marks, expected);
}

TEST(CostTrace, IsDeterministicWithoutAClock) {
    EXPECT_EQ(traced().text, traced().text);
}

TEST(CostTrace, ShowsClockTimesOnASeparateTrack) {
    double now = 1000.0;
    const Traced all = traced([&] { return now += 5.0; });
    const std::vector<Json> ticks = slices(Json::parse(all.text), "tick", 2);
    ASSERT_EQ(ticks.size(), static_cast<std::size_t>(all.summary.ticks) + 1);
    EXPECT_EQ(ticks[0].at("ts"), 0.0);
    EXPECT_EQ(ticks[7].at("ts"), 35.0);
    EXPECT_EQ(ticks[7].at("dur"), 5.0);
    EXPECT_TRUE(slices(Json::parse(traced().text), "tick", 2).empty());
}

}  // namespace
}  // namespace campuswalk::engine
