#include "engine/expect/popup_evaluators.h"

#include <gtest/gtest.h>

#include "tests/engine/expect/single_evaluator.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

Event opened(const std::string& building, const std::string& title, const std::string& body) {
    return made_event("popup.open " + building, {{"title", Text{title}}, {"body", Text{body}}});
}

// ---- popup ----------------------------------------------------------------------------------------------

ExpectPopup popup_of_library() {
    ExpectPopup expected;
    expected.mark = {"a.walk.yaml", 8, 5};
    expected.building.glob = "library";
    return expected;
}

std::optional<Failure> evaluated(const ExpectPopup& expected) {
    SingleEvaluator evaluator(expected);
    TickFeed(evaluator)
        .tick({"popup.close library"})
        .with({opened("library", "Main Library", "Open 08-22."), opened("hall", "Hall", "Books.")}, {0, 0, 0})
        .with({opened("library", "Main Library", "Closed.")}, {0, 0, 0});
    return evaluator.failure();
}

TEST(PopupEvaluator, PassesIfThePopupOpens) {
    EXPECT_FALSE(evaluated(popup_of_library()));
    ExpectPopup expected = popup_of_library();
    expected.title = "Main*";
    expected.body = "*22.";
    expected.times = {1, {}, {}};
    EXPECT_FALSE(evaluated(expected));
}

TEST(PopupEvaluator, FailsIfThePopupNeverOpens) {
    ExpectPopup expected = popup_of_library();
    expected.building.glob = "lab*";
    expect_failure(evaluated(expected), 8, "popup", {"'lab*'", "0 times", "at least 1"});
}

TEST(PopupEvaluator, FailsIfTheTextDiffers) {
    ExpectPopup expected = popup_of_library();
    expected.title = "Small*";
    expected.body = "Open*";
    expect_failure(evaluated(expected), 8, "popup",
                   {"'library'", "'Small*'", "'Open*'", "0 times", "at least 1", "library at 0.200 s",
                    "'Main Library'", "'Closed.'"});
}

TEST(PopupEvaluator, CountsOpenings) {
    ExpectPopup expected = popup_of_library();
    expected.times = {{}, 3, {}};
    expect_failure(evaluated(expected), 8, "popup", {"'library'", "2 times", "at least 3"});
    expected.times = {0, {}, {}};
    expect_failure(evaluated(expected), 8, "popup", {"'library'", "2 times", "exactly 0"});
    expected.times = {{}, {}, 2};
    EXPECT_FALSE(evaluated(expected));
}

// ---- visits ---------------------------------------------------------------------------------------------

/// Three buildings to visit, and a shed without a pop-up.
scene::Campus village() {
    scene::Campus campus = empty_campus();
    for (const char* id : {"hall", "lab", "library", "shed"}) {
        add_building(campus, id);
        add_box(campus, std::string(id) + "/door", {0, 0, 0}, {1, 1, 1},
                {collision::Detection::trigger, id, std::string(id) != "shed", ""});
    }
    return campus;
}

std::optional<Failure> visited(const std::vector<std::string>& globs, double ratio = 1.0) {
    const scene::Campus campus = village();
    ExpectVisits expected{{"a.walk.yaml", 9, 5}, {}, ratio};
    for (const std::string& glob : globs) {
        expected.buildings.push_back({{}, glob});
    }
    SingleEvaluator evaluator(expected, campus);
    TickFeed(evaluator)
        .tick({"popup.open hall"})
        .tick({"popup.close hall", "popup.open hall", "popup.open lab"});
    return evaluator.failure();
}

TEST(VisitsEvaluator, RequiresEachBuilding) {
    EXPECT_FALSE(visited({"hall"}));
    EXPECT_FALSE(visited({"lab", "h*"}));
    expect_failure(visited({"hall", "l*"}), 9, "visits", {"2 of 3", "expected 3", "library"});
    expect_failure(visited({"library"}), 9, "visits", {"0 of 1", "expected 1", "library"});
}

TEST(VisitsEvaluator, RequiresAShareOfTheBuildings) {
    EXPECT_FALSE(visited({"*"}, 0.66)) << "of those that have a pop-up";
    expect_failure(visited({"*"}, 0.67), 9, "visits", {"2 of 3", "expected 3", "library"});
    EXPECT_FALSE(visited({"library"}, 0.0));
}

}  // namespace
}  // namespace campuswalk::engine
