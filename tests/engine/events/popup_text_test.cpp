#include "engine/events/popup_text.h"

#include <gtest/gtest.h>

namespace campuswalk::engine {
namespace {

scene::Building library() {
    scene::Building building;
    building.id = "library";
    building.title = "Main Library";
    building.kind = "house of books";
    building.hours = "08-22";
    building.floors = 4;
    building.info = {{"phone", "1234"}, {"opened-in", "1934"}};
    return building;
}

std::string text(const std::string& written, const PopupFacts& facts = {}) {
    scene::Building building = library();
    building.text = written;
    return popup_text(building, facts);
}

TEST(PopupText, IsUnchangedWithoutBraces) {
    EXPECT_EQ(text("Four floors of books.\nRing twice."), "Four floors of books.\nRing twice.");
    EXPECT_EQ(text(""), "");
}

TEST(PopupText, SubstitutesTheBuildingsData) {
    EXPECT_EQ(text("{title} ({id}), a {kind} with {floors} floors, {hours}."),
              "Main Library (library), a house of books with 4 floors, 08-22.");
    EXPECT_EQ(text("Call {phone}; since {opened-in}"), "Call 1234; since 1934");
}

TEST(PopupText, SubstitutesVisitsAndTime) {
    EXPECT_EQ(text("Visit {visits} at {time}", {3, 0.0}), "Visit 3 at 00:00");
    EXPECT_EQ(text("{time}", {1, 59.999}), "00:59");
    EXPECT_EQ(text("{time}", {1, 60.0}), "01:00");
    EXPECT_EQ(text("{time}", {1, 6000.5}), "100:00");
}

TEST(PopupText, UnescapesDoubledBraces) {
    EXPECT_EQ(text("{{title}} is {title}}"), "{title} is Main Library}");
    EXPECT_EQ(text("{{{{ }}}}"), "{{ }}");
    EXPECT_EQ(text("a } b"), "a } b") << "a single closing brace is plain text";
}

TEST(PopupText, IsInvalidWithAnUnclosedBrace) {
    EXPECT_FALSE(text_parts("from {id to"));
    EXPECT_TRUE(text_parts("from {id} to"));
}

TEST(PopupTitle, SubstitutesVariablesExceptItself) {
    scene::Building building = library();
    building.title = "{id}, visit {visits}{title}";
    EXPECT_EQ(popup_title(building, {2, 0.0}), "library, visit 2");
    building.text = "{title}!";
    EXPECT_EQ(popup_text(building, {2, 0.0}), "library, visit 2!");
}

TEST(PopupVariables, AreTheBuiltInOnesAndTheBuildingsOwn) {
    EXPECT_EQ(popup_variables(library()), std::vector<std::string>({"id", "title", "kind", "hours", "floors",
                                                                    "visits", "time", "phone", "opened-in"}));
}

}  // namespace
}  // namespace campuswalk::engine
