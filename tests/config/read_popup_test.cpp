#include "config/loader/campus/read_popup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"
#include "tests/support/says.h"

namespace campuswalk::config {
namespace {

using support::says;
using testing::ElementsAre;

/// Keys of a building on line 3 and of its collider on line 4.
class ReadPopup : public testing::Test {
protected:
    test::Lines about(const std::string& building, const std::string& collider = "") {
        return folder_.about_campus("scenes: [{file: a.obj}]\nbuildings:\n  - {id: hut, " + building +
                                    "}\ncolliders: [{id: door, shape: mesh, mode: solid, building: hut" +
                                    collider + "}]\n");
    }
    scene::CampusDescription read(const std::string& building, const std::string& collider = "") {
        EXPECT_THAT(about(building, collider), ElementsAre());
        return folder_.campus();
    }

    test::ConfigFolder folder_;
};

TEST_F(ReadPopup, ReadsWhenAPopUpOpens) {
    const scene::ColliderDescription door =
        read("title: Hut", ", popup: {once: true, cooldown: 5, dwell: 1.5}").colliders.at(0);
    EXPECT_TRUE(door.popup);
    EXPECT_TRUE(door.popup_rule.once);
    EXPECT_EQ(door.popup_rule.cooldown, 5.0);
    EXPECT_EQ(door.popup_rule.dwell, 1.5);
}

TEST_F(ReadPopup, TakesTheBuildingsRuleUnlessTheColliderHasOne) {
    EXPECT_EQ(read("title: Hut, popup: {dwell: 2}").colliders.at(0).popup_rule.dwell, 2.0);
    EXPECT_TRUE(read("title: Hut, popup: {dwell: 2}").colliders.at(0).popup);
    EXPECT_FALSE(read("title: Hut, popup: false").colliders.at(0).popup);
    EXPECT_TRUE(read("title: Hut, popup: false", ", popup: true").colliders.at(0).popup);
    const auto own = read("title: Hut, popup: {dwell: 2}", ", popup: {once: true}").colliders.at(0);
    EXPECT_TRUE(own.popup_rule.once);
    EXPECT_EQ(own.popup_rule.dwell, 0.0) << "the collider's rule replaces the building's entirely";
    EXPECT_FALSE(read("title: Hut, popup: {dwell: 2}", ", popup: false").colliders.at(0).popup);
}

TEST_F(ReadPopup, DiagnosesBadRules) {
    EXPECT_THAT(about("title: Hut, popup: {dwell: -1, onec: true}"),
                ElementsAre(says("a.campus.yaml:3:42: error bad-value", {"'dwell'", "'-1'"}),
                            says("a.campus.yaml:3:46: error unknown-key", {"'onec'", "'popup'", "'once'"})));
    EXPECT_THAT(about("title: Hut, popup: sometimes"),
                ElementsAre(says("a.campus.yaml:3:34: error wrong-type", {"'popup'", "'sometimes'"})));
}

TEST_F(ReadPopup, ReadsFreeFields) {
    const auto building =
        read(
            "title: \"Hut of {owner}\", text: \"{title}: {phone}, {{open}} {visits} {time}\", "
            "info: {owner: Ada, phone: 123}")
            .buildings.at(0);
    ASSERT_EQ(building.info.size(), 2U);
    EXPECT_EQ(building.info[0].name, "owner");
    EXPECT_EQ(building.info[0].value, "Ada");
    EXPECT_EQ(building.info[1].value, "123");
}

TEST_F(ReadPopup, DiagnosesUndefinedVariables) {
    EXPECT_THAT(about("title: \"{title}\", text: \"{visit} and {id\""),
                ElementsAre(says("a.campus.yaml:3:22: error unknown-name", {"'title'", "{title}"}),
                            says("a.campus.yaml:3:39: error bad-value", {"'text'", "'{'"})));
    EXPECT_THAT(about("title: Hut, text: \"{visit}\""),
                ElementsAre(says("a.campus.yaml:3:33: error unknown-name", {"'text'", "{visit}"})));
}

TEST_F(ReadPopup, ReportsEachUnknownVariableAtTheStartOfItsText) {
    for (const std::string text : {"'{a}{visits}{b}'", "\"tab\\t{a}{b}\"", "'it''s {a} {b}'"}) {
        EXPECT_THAT(about("title: Hut, text: " + text),
                    ElementsAre(says("a.campus.yaml:3:33: error unknown-name", {"'text'", "{a}"}),
                                says("a.campus.yaml:3:33: error unknown-name", {"'text'", "{b}"})))
            << text;
    }
}

TEST_F(ReadPopup, DiagnosesDuplicateAndInvalidFieldNames) {
    EXPECT_THAT(about("title: Hut, info: {hours: 8, A: b}"),
                ElementsAre(says("a.campus.yaml:3:34: error duplicate-name", {"'hours'"}),
                            says("a.campus.yaml:3:44: error bad-value")));
}

}  // namespace
}  // namespace campuswalk::config
