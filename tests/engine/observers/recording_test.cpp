#include "engine/observers/recording.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/observers/text_log.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

using Json = nlohmann::json;

struct Recorded {  // NOLINT(bugprone-exception-escape): its JSON is moved without exceptions
    std::string text;
    Json json;
    std::vector<std::string> log;
    Recorder recorder;
    WalkSummary summary;
};

Recorded recorded(const scene::Campus& campus, const Walk& walk) {
    Recorded result;
    Recording recording([&](std::string_view line) { result.text.append(line).append("\n"); }, campus);
    TextLog log([&](std::string_view line) { result.log.emplace_back(line); });
    const std::array<Observer*, 3> observers = {&recording, &log, &result.recorder};
    result.summary = run_walk(campus, walk, observers);
    result.json = Json::parse(result.text);
    return result;
}

/// A column of the way, summed up.
std::vector<double> column(const Json& recording, const char* name) {
    std::vector<double> values;
    double value = 0.0;
    for (const Json& difference : recording.at("way").at(name)) {
        values.push_back(value += difference.get<double>());
    }
    return values;
}

/// What the format says of a tick between key frames.
double shown(const Json& recording, const char* name, double tick) {
    const std::vector<double> ticks = column(recording, "tick");
    const std::vector<double> values = column(recording, name);
    const auto cuts = recording.at("way").at("cut").get<std::vector<std::size_t>>();
    std::size_t k = 0;
    while (k + 1 < ticks.size() && ticks[k + 1] <= tick) {
        ++k;
    }
    if (k + 1 == ticks.size() || std::ranges::find(cuts, k + 1) != cuts.end()) {
        return values[k];
    }
    return values[k] + (tick - ticks[k]) / (ticks[k + 1] - ticks[k]) * (values[k + 1] - values[k]);
}

double turns_apart(double a, double b) {
    const double turns = (a - b) / 3600.0;
    return std::abs(turns - std::round(turns)) * 3600.0;
}

void expect_path(const Recorded& walk) {
    for (Tick tick = 0; tick <= walk.summary.ticks; ++tick) {
        const AvatarState& avatar = walk.recorder.at(tick);
        const auto t = static_cast<double>(tick);
        ASSERT_NEAR(shown(walk.json, "x", t), 1000.0 * avatar.position.x(), 0.501) << tick;
        ASSERT_NEAR(shown(walk.json, "y", t), 1000.0 * avatar.position.y(), 0.501) << tick;
        ASSERT_NEAR(shown(walk.json, "z", t), 1000.0 * avatar.position.z(), 0.501) << tick;
        const double tenths = 1800.0 / std::numbers::pi;
        ASSERT_LT(turns_apart(shown(walk.json, "yaw", t), tenths * avatar.yaw), 1.01) << tick;
        ASSERT_NEAR(shown(walk.json, "pitch", t), tenths * avatar.pitch, 1.01) << tick;
    }
}

TEST(Recording, ShowsEveryTickOfAWalk) {
    const scene::Campus campus = walled_yard();
    const Recorded walk = recorded(
        campus, walk_of({spawn_at({1, 0, 2}), walk_to(3.0, -1.0), turn_by(270), turn_by(-300),
                         look_at({"up", {0, 4, 0}, true}), jump_up(3.0, 1.0), teleport_to({-2, 0, 1}, 1.0),
                         walk_to(-2.5, 2.5), set_height(1.0), follow({{-1, 0, 2}, {0, 0, -2}, {2, 0, 1}})}));
    expect_path(walk);
    EXPECT_EQ(walk.json.at("ticks"), walk.summary.ticks);
    EXPECT_EQ(walk.json.at("way").at("cut").size(), 2U);
    EXPECT_LT(walk.json.at("way").at("tick").size(), static_cast<std::size_t>(walk.summary.ticks) / 2);
}

TEST(Recording, ShowsAFallOutOfTheWorld) {
    const scene::Campus campus = level_campus(3.0);
    const Recorded walk = recorded(campus, walk_of({spawn_at({0, 0, 0}), walk_to(20.0, 0.0)}));
    EXPECT_FALSE(walk.summary.passed);
    expect_path(walk);
}

TEST(Recording, ContainsTheLogAsItIs) {
    scene::Campus campus = level_campus();
    add_box(campus, "odd \"name\"\n<script>\xff", {1, 0, -1}, {2, 2, 1});
    const Recorded walk = recorded(campus, walk_of({spawn_at({0, 0, 0}), walk_to(3.0, 0.0)}));
    ASSERT_EQ(walk.json.at("log").size() + 1, walk.log.size());  // the header isn't in it
    for (std::size_t i = 0; i + 1 < walk.log.size(); ++i) {
        std::string line = walk.log[i + 1];
        for (std::size_t at = 0; (at = line.find('\xff')) != std::string::npos;) {
            line.replace(at, 1, "\xef\xbf\xbd");
        }
        EXPECT_EQ(walk.json["log"][i], line);
    }
}

TEST(Recording, StepsFollowOneAnotherWithoutGaps) {
    const Walk played = walk_of({spawn_at({0, 0, 0}), snapshot("first"), wait_for(0.5), set_height(1.2),
                                 snapshot("second"), wait_for(0.25), snapshot("last")});
    const Recorded walk = recorded(level_campus(), played);
    const Json& steps = walk.json.at("steps");
    ASSERT_EQ(steps.size(), played.steps.size());
    const std::vector<std::string> texts = {"spawn: start",  "snapshot: first",  "wait: 0.5",
                                            "crouch: 1.2",   "snapshot: second", "wait: 0.25",
                                            "snapshot: last"};
    for (std::size_t i = 0; i < steps.size(); ++i) {
        EXPECT_EQ(steps[i].at("text"), texts[i]);
        EXPECT_EQ(steps[i].at("to"), i + 1 < steps.size() ? steps[i + 1].at("from") : walk.json.at("ticks"));
    }
    EXPECT_EQ(steps[0].at("from"), 0);
    EXPECT_EQ(steps[2].at("from"), 1);   // the tick after the spawn
    EXPECT_EQ(steps[3].at("from"), 30);  // executed at the end of the wait's last tick
    EXPECT_EQ(steps[5].at("from"), 31);
    EXPECT_EQ(walk.json.at("avatar").at("crouch_height"), 1.2);
    EXPECT_NEAR(walk.json.at("avatar").at("crouch_eye_height").get<double>(), 1.65 * 1.2 / 1.8, 1e-3);
}

TEST(Recording, StepsThatNeverBeginAreNotListed) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {1, 0, -5}, {2, 2, 5});
    const Recorded walk =
        recorded(campus, walk_of({spawn_at({0, 0, 0}), walk_to(3.0, 0.0), wait_for(1.0), snapshot("end")}));
    EXPECT_FALSE(walk.summary.passed);
    ASSERT_EQ(walk.json.at("steps").size(), 2U);
    EXPECT_EQ(walk.json["steps"][1].at("to"), walk.summary.ticks);
}

TEST(Recording, ContactsAreWhereTheBodyTouches) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {1, 0, -5}, {2, 2, 5});
    WalkToStep into = walk_to(3.0, 0.0);
    into.if_blocked = IfBlocked::proceed;
    const Recorded walk = recorded(campus, walk_of({spawn_at({0, 0, 0}), into, walk_to(-1.0, 0.0)}));
    const Json& contacts = walk.json.at("contacts");
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_EQ(contacts[0].at("object"), "wall");
    EXPECT_NEAR(contacts[0].at("point")[0].get<double>(), 1.0, 1e-3);
    EXPECT_NEAR(contacts[0].at("normal")[0].get<double>(), -1.0, 1e-3);
    EXPECT_EQ(contacts[0].at("tick"), walk.recorder.events("collision.enter wall").at(0).tick);
    EXPECT_EQ(contacts[0].at("to"), walk.recorder.events("collision.exit wall").at(0).tick);
}

TEST(Recording, PopupsHaveTheirTextsAndSpans) {
    scene::Campus campus = level_campus();
    add_building(campus, "hut", "The Hut", "08-22", "Nothing \"behind\" it.");
    add_box(campus, "door", {1, 0, -1}, {2, 2, 1}, {collision::Detection::trigger, "hut", true, ""});
    const Recorded walk =
        recorded(campus, walk_of({spawn_at({0, 0, 0}), walk_to(5.0, 0.0), walk_to(1.5, 0.0)}));
    const Json& popups = walk.json.at("popups");
    ASSERT_EQ(popups.size(), 2U);
    EXPECT_EQ(popups[0].at("building"), "hut");
    EXPECT_EQ(popups[0].at("title"), "The Hut");
    EXPECT_EQ(popups[0].at("text"), "Nothing \"behind\" it.");
    EXPECT_EQ(popups[0].at("from"), walk.recorder.events("popup.open hut").at(0).tick);
    EXPECT_EQ(popups[0].at("to"), walk.recorder.events("popup.close hut").at(0).tick);
    EXPECT_EQ(popups[1].at("to"), walk.summary.ticks);
}

}  // namespace
}  // namespace campuswalk::engine
