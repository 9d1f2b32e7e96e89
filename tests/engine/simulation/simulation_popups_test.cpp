#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

using collision::Detection;
using Lines = std::vector<std::string>;

ObjectTraits trigger_of(const std::string& building, bool popup = true) {
    return {Detection::trigger, building, popup, ""};
}

Lines stroll(const scene::Campus& campus) {
    Walk walk = walk_of({spawn_at({0, 0, 0}), walk_to(0, -8)});
    walk.sim.stay_every = 100.0;
    return run(campus, walk).recorder.event_lines();
}

TEST(PopupEvents, OpenAfterTheEnterAndCloseBeforeTheExit) {
    scene::Campus campus = level_campus();
    add_building(campus, "hall");
    add_box(campus, "hall/door", {-1, 0, -3.5}, {1, 2, -2.5}, trigger_of("hall"));
    EXPECT_EQ(stroll(campus), Lines({"trigger.enter hall/door", "popup.open hall", "popup.close hall",
                                     "trigger.exit hall/door", "avatar.arrive goal"}));
}

TEST(PopupEvents, HaveTheTimeOfTheirContact) {
    scene::Campus campus = level_campus();
    add_building(campus, "hall");
    add_box(campus, "hall/door", {-1, 0, -3.5}, {1, 2, -2.5}, trigger_of("hall"));
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), walk_to(0, -8)}));
    const Event enter = result.recorder.events("trigger.enter")[0];
    const Event open = result.recorder.events("popup.open")[0];
    EXPECT_EQ(open.tick, enter.tick);
    EXPECT_EQ(open.at, enter.at);
    const Event exit = result.recorder.events("trigger.exit")[0];
    const Event close = result.recorder.events("popup.close")[0];
    EXPECT_EQ(close.tick, exit.tick);
    EXPECT_EQ(close.at, exit.at);
    EXPECT_TRUE(close.fields.empty());
}

TEST(PopupEvents, OpenOnceForAllObjectsOfABuilding) {
    scene::Campus campus = level_campus();
    add_building(campus, "hall");
    add_box(campus, "hall/door", {-1, 0, -3.5}, {1, 2, -2.5}, trigger_of("hall"));
    add_box(campus, "hall/room", {-1, 0, -5.5}, {1, 2, -3.0}, trigger_of("hall"));
    EXPECT_EQ(stroll(campus), Lines({"trigger.enter hall/door", "popup.open hall", "trigger.enter hall/room",
                                     "trigger.exit hall/door", "popup.close hall", "trigger.exit hall/room",
                                     "avatar.arrive goal"}));
}

TEST(PopupEvents, OpenAgainAfterClosing) {
    scene::Campus campus = level_campus();
    add_building(campus, "hall");
    add_box(campus, "hall/front", {-1, 0, -2.5}, {1, 2, -2.0}, trigger_of("hall"));
    add_box(campus, "hall/back", {-1, 0, -5.5}, {1, 2, -5.0}, trigger_of("hall"));
    EXPECT_EQ(stroll(campus), Lines({"trigger.enter hall/front", "popup.open hall", "popup.close hall",
                                     "trigger.exit hall/front", "trigger.enter hall/back", "popup.open hall",
                                     "popup.close hall", "trigger.exit hall/back", "avatar.arrive goal"}));
}

TEST(PopupEvents, OccurInAllThreeDetectionModes) {
    scene::Campus campus = level_campus();
    add_building(campus, "hall");
    add_box(campus, "hall/sight", {-1, 0, -14}, {1, 3, -13}, {Detection::ray, "hall", true, ""});
    add_building(campus, "shed");
    add_box(campus, "shed/walls", {-1, 0, -9}, {1, 1, -8}, {Detection::solid, "shed", true, ""});
    Walk walk = walk_of({spawn_at({0, 0, 0}), walk_to(0, -12)});
    walk.sim.stay_every = 100.0;
    EXPECT_EQ(
        run(campus, walk).recorder.event_lines(),
        Lines({"ray.enter hall/sight", "popup.open hall", "collision.enter shed/walls", "popup.open shed",
               "avatar.stuck stroll", "avatar.blocked goal", "popup.close hall", "ray.exit hall/sight",
               "popup.close shed", "collision.exit shed/walls", "expect.fail blocked"}));
}

TEST(PopupEvents, DoNotOccurForObjectsWithoutPopup) {
    scene::Campus campus = level_campus();
    add_building(campus, "hall");
    add_box(campus, "hall/door", {-1, 0, -3.5}, {1, 2, -2.5}, trigger_of("hall", false));
    add_box(campus, "bench", {-1, 0, -5.5}, {1, 2, -4.5}, trigger_of(""));
    EXPECT_EQ(stroll(campus), Lines({"trigger.enter hall/door", "trigger.exit hall/door",
                                     "trigger.enter bench", "trigger.exit bench", "avatar.arrive goal"}));
}

TEST(PopupEvents, OpenAndCloseWithinATick) {
    scene::Campus campus = level_campus();
    add_building(campus, "hall");
    add_box(campus, "hall/door", {-1, 0, -2.5}, {1, 2, -2.4}, trigger_of("hall"));
    WalkToStep dash = walk_to(0, -20);
    dash.speed = 60.0;
    EXPECT_EQ(run(campus, walk_of({spawn_at({0, 0, 0}), dash})).recorder.event_lines(),
              Lines({"trigger.enter hall/door", "popup.open hall", "popup.close hall",
                     "trigger.exit hall/door", "avatar.arrive goal"}));
}

TEST(PopupEvents, AreListedOldestFirstInTheRecord) {
    scene::Campus campus = level_campus();
    add_building(campus, "hall");   // 0
    add_building(campus, "tower");  // 1
    add_box(campus, "hall/zone", {-1, 0, -5}, {1, 2, -3}, trigger_of("hall"));
    add_box(campus, "tower/zone", {-1, 0, -4}, {1, 2, -2}, trigger_of("tower"));
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), walk_to(0, -8)}));
    std::vector<std::vector<std::size_t>> changes = {{}};
    for (const Recorder::TickState& state : result.recorder.states()) {
        if (state.open_popups != changes.back()) {
            changes.push_back(state.open_popups);
        }
    }
    EXPECT_EQ(changes, std::vector<std::vector<std::size_t>>({{}, {1}, {1, 0}, {0}, {}}));
}

TEST(PopupEvents, ShowTheBuildingsData) {
    const auto shown = [](const std::string& hours, const std::string& text) {
        scene::Campus campus = level_campus();
        add_building(campus, "hall", "Great Hall", hours, text);
        add_box(campus, "hall/door", {-1, 0, -1}, {1, 2, 1}, trigger_of("hall"));
        const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0})}));
        const Event open = result.recorder.events("popup.open hall").at(0);
        EXPECT_EQ(field<Text>(open, "title").value, "Great Hall");
        return field<Text>(open, "body").value;
    };
    EXPECT_EQ(shown("08-22", "Four floors."), "Open 08-22. Four floors.");
    EXPECT_EQ(shown("08-22", ""), "Open 08-22.");
    EXPECT_EQ(shown("", "Four floors."), "Four floors.");
    EXPECT_EQ(shown("", ""), "");
}

// ---- once, cooldown, dwell, variables -------------------------------------------------------------------

/// Walks through a door at 2.0 to 3.0 m, there and back.
RecordedRun there_and_back(const scene::PopupRule& rule, const std::string& text = "") {
    scene::Campus campus = level_campus();
    add_building(campus, "hall", "Hall", "", text);
    add_box(campus, "hall/door", {-1, 0, -3}, {1, 2, -2}, trigger_of("hall"));
    campus.objects.back().popup_rule = rule;
    return run(campus, walk_of({spawn_at({0, 0, 0}), walk_to(0, -6), walk_to(0, 0)}));
}

std::vector<double> times_of(const RecordedRun& result, const std::string& words) {
    std::vector<double> times;
    for (const Event& event : result.recorder.events(words)) {
        times.push_back(static_cast<double>(event.tick) / 60.0);
    }
    return times;
}

TEST(PopupTiming, OnceMeansOncePerWalk) {
    EXPECT_EQ(there_and_back({}).recorder.events("popup.open").size(), 2U);
    const RecordedRun result = there_and_back({true, 0.0, 0.0});
    EXPECT_EQ(result.recorder.events("popup.open").size(), 1U);
    EXPECT_EQ(result.recorder.events("popup.close").size(), 1U);
    EXPECT_EQ(result.recorder.events("trigger.enter").size(), 2U);
}

TEST(PopupTiming, CooldownStartsWhenThePopupCloses) {
    const RecordedRun plain = there_and_back({});
    const double pause = times_of(plain, "popup.open")[1] - times_of(plain, "popup.close")[0];
    EXPECT_EQ(there_and_back({false, pause, 0.0}).recorder.events("popup.open").size(), 2U);
    EXPECT_EQ(there_and_back({false, pause + 1.0 / 60.0, 0.0}).recorder.events("popup.open").size(), 1U);
}

TEST(PopupTiming, DwellTimeDelaysOrPreventsOpening) {
    const RecordedRun late = there_and_back({false, 0.0, 0.5});
    const std::vector<double> opened = times_of(late, "popup.open");
    const std::vector<double> entered = times_of(late, "trigger.enter");
    ASSERT_EQ(opened.size(), 2U);
    EXPECT_NEAR(opened[0], entered[0] + 0.5, 1e-9);
    EXPECT_NEAR(opened[1], entered[1] + 0.5, 1e-9);
    EXPECT_TRUE(there_and_back({false, 0.0, 5.0}).recorder.events("popup.*").empty())
        << "the contact ended before";
}

TEST(PopupTexts, ContainVisitsAndTime) {
    const RecordedRun result = there_and_back({}, "{title}: visit {visits} at {time}.");
    const std::vector<Event> opened = result.recorder.events("popup.open");
    ASSERT_EQ(opened.size(), 2U);
    EXPECT_EQ(field<Text>(opened[0], "body").value, "Hall: visit 1 at 00:01.") << "1.7 m at 1.4 m/s";
    EXPECT_EQ(field<Text>(opened[1], "body").value, "Hall: visit 2 at 00:06.");
}

}  // namespace
}  // namespace campuswalk::engine
