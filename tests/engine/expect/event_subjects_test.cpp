#include "engine/expect/event_subjects.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

using collision::Detection;

scene::Campus campus_of_each_mode() {
    scene::Campus campus = level_campus();
    add_building(campus, "hall");
    add_building(campus, "shed");
    add_box(campus, "hall/door", {0, 0, 0}, {1, 1, 1}, {Detection::trigger, "hall", true, ""});
    add_box(campus, "hall/walls", {3, 0, 0}, {4, 1, 1},
            {Detection::solid | Detection::ray, "hall", true, ""});
    add_box(campus, "shed/walls", {6, 0, 0}, {7, 1, 1}, {Detection::solid, "shed", false, ""});
    return campus;
}

Walk walk_of_each_step() {
    return walk_of({spawn_at({0, 0, 9}, 0.0, "gate"), walk_to(1, 1, "square"), wait_for(1), turn_by(90),
                    look_at({"tower", {0, 9, 0}, true}), teleport_to({9, 0, 9}, {}, "roof"),
                    spawn_at({8, 0, 8}, 0.0, "yard"), snapshot("picture")});
}

std::vector<std::string> names(const std::string& words) {
    const scene::Campus campus = campus_of_each_mode();
    const Walk walk = walk_of_each_step();
    std::vector<std::string> found = EventSubjects(campus, walk).names(pattern(words));
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

bool can_happen(const std::string& words) {
    const scene::Campus campus = campus_of_each_mode();
    const Walk walk = walk_of_each_step();
    return EventSubjects(campus, walk).can_happen(pattern(words));
}

using Names = std::vector<std::string>;

TEST(EventSubjects, IncludeObjectsByTheirDetectionModes) {
    for (const char* phase : {"enter", "stay", "exit"}) {
        EXPECT_EQ(names(std::string("collision.") + phase), Names({"ground", "hall/walls", "shed/walls"}));
        EXPECT_EQ(names(std::string("trigger.") + phase), Names({"hall/door"}));
        EXPECT_EQ(names(std::string("ray.") + phase), Names({"hall/walls"}));
    }
}

TEST(EventSubjects, IncludeBuildingsWithAnObjectThatOpensTheirPopup) {
    EXPECT_EQ(names("popup.open"), Names({"hall"}));
    EXPECT_EQ(names("popup.close"), Names({"hall"}));
}

TEST(EventSubjects, IncludeTheLabelsOfStepsForAvatarEvents) {
    EXPECT_EQ(names("avatar.arrive"), Names({"square"}));
    EXPECT_EQ(names("avatar.blocked"), Names({"square"}));
    EXPECT_EQ(names("avatar.teleport"), Names({"roof"}));
    EXPECT_EQ(names("avatar.spawn"), Names({"yard"})) << "the first spawn is walk.start";
    EXPECT_EQ(names("snapshot.take"), Names({"picture"}));
}

TEST(EventSubjects, IncludeBodyEventsOnlyIfTheWalkHasTheirSteps) {
    const scene::Campus campus = campus_of_each_mode();
    const Walk walk = walk_of({spawn_at({0, 0, 9}), jump_up(2.0), set_height(1.0), set_height(1.8),
                               follow({{1, 0, 1}, {2, 0, 2}}), disable("hall/*"), enable("hall/door")});
    const EventSubjects subjects(campus, walk);
    const auto names = [&](const std::string& kind) { return subjects.names(pattern(kind)); };
    EXPECT_EQ(names("avatar.jump"), Names({"stroll"}));
    EXPECT_EQ(names("avatar.crouch"), Names({"stroll"}));
    EXPECT_EQ(names("avatar.stand"), Names({"stroll"}));
    EXPECT_EQ(names("avatar.arrive"), Names({"goal"}));
    EXPECT_EQ(names("object.disable"), Names({"hall/door", "hall/walls"}));
    EXPECT_EQ(names("object.enable"), Names({"hall/door"}));
    EXPECT_EQ(names("avatar.depenetrated"), Names({"start", "stroll"}));
    EXPECT_FALSE(can_happen("avatar.jump stroll"));
}

TEST(EventSubjects, IncludeTheWalksNameForWalkEvents) {
    for (const char* kind : {"walk.start", "walk.end", "avatar.landed", "avatar.fell", "avatar.stuck"}) {
        EXPECT_EQ(names(kind), Names({"stroll"})) << kind;
    }
    EXPECT_EQ(names("expect.fail"), Names()) << "no evaluator sees a verdict";
}

TEST(EventSubjects, IncludeThoseOfAllKindsThatMatchAGlob) {
    EXPECT_EQ(names("trigger.*"), Names({"hall/door"}));
    EXPECT_EQ(names("*.enter"), Names({"ground", "hall/door", "hall/walls", "shed/walls"}));
}

TEST(EventSubjects, AcceptPossibleEvents) {
    for (const char* words : {"trigger.enter hall/door", "trigger.* hall/*", "*.enter hall/walls",
                              "popup.open h*", "avatar.arrive square", "walk.end stroll",
                              "ray.exit hall/walls", "*.enter hall/do?r", "* picture"}) {
        EXPECT_TRUE(can_happen(words)) << words;
    }
}

TEST(EventSubjects, RejectImpossibleEvents) {
    for (const char* words :
         {"trigger.enter hall/walls", "ray.enter shed/walls", "popup.open shed", "trigger.enter hall",
          "popup.open hall/door", "avatar.arrive tower", "avatar.spawn gate", "walk.end gate", "* nowhere"}) {
        EXPECT_FALSE(can_happen(words)) << words;
    }
}

TEST(EventSubjects, AcceptEveryKindWithoutAnObject) {
    for (const EventKind kind : event_kinds()) {
        EXPECT_TRUE(can_happen(std::string(name_of(kind)))) << name_of(kind);
    }
}

}  // namespace
}  // namespace campuswalk::engine
