#include "engine/report/outcome.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace campuswalk::engine {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Failure failure(const std::string& code) {
    return {{"a.walk.yaml", 9, 5}, code, "not as expected", {}};
}

WalkStatus xfail(const std::vector<std::string>& codes = {}, const std::string& reason = "") {
    return {{"a.walk.yaml", 3, 9}, WalkStatus::Kind::xfail, reason, codes};
}

/// The message about an xfail that did not fail as expected.
std::string message_of(const std::vector<Failure>& failures, const WalkStatus& status) {
    const EvaluatedWalk evaluated = outcome_of_failures(failures, status);
    EXPECT_EQ(evaluated.outcome, Outcome::failed);
    EXPECT_EQ(evaluated.failures.size(), failures.size() + 1) << "the walk's own failures remain";
    EXPECT_EQ(evaluated.failures.back().code, "xfail");
    EXPECT_EQ(evaluated.failures.back().mark.line, 3) << "the line of the status";
    return evaluated.failures.back().message;
}

TEST(EvaluatorOutcome, IsTheWalksOwnUnlessItIsExpectedToFail) {
    EXPECT_EQ(outcome_of_failures({}, {}).outcome, Outcome::passed);
    const EvaluatedWalk evaluated = outcome_of_failures({failure("never")}, {});
    EXPECT_EQ(evaluated.outcome, Outcome::failed);
    EXPECT_EQ(evaluated.failures.size(), 1U);
}

TEST(EvaluatorOutcome, XfailPassesIfTheWalkFails) {
    EXPECT_EQ(outcome_of_failures({failure("never")}, xfail()).outcome, Outcome::passed);
    const EvaluatedWalk evaluated =
        outcome_of_failures({failure("near"), failure("never"), failure("near")}, xfail({"never", "near"}));
    EXPECT_EQ(evaluated.outcome, Outcome::passed) << "in any order and number";
    EXPECT_EQ(evaluated.failures.size(), 3U);
}

TEST(EvaluatorOutcome, XfailFailsIfTheWalkPasses) {
    EXPECT_NE(message_of({}, xfail()), "");
    EXPECT_THAT(message_of({}, xfail({"never"}, "the door is locked")),
                AllOf(HasSubstr("never"), HasSubstr("the door is locked")));
}

TEST(EvaluatorOutcome, XfailFailsUnlessTheCodesAreThoseExpected) {
    EXPECT_THAT(message_of({failure("blocked")}, xfail({"never"})),
                AllOf(HasSubstr("never"), HasSubstr("blocked")));
    EXPECT_THAT(message_of({failure("never"), failure("blocked")}, xfail({"never"})),
                HasSubstr("blocked, never"));
    EXPECT_THAT(message_of({failure("never")}, xfail({"never", "blocked"})), HasSubstr("blocked, never"));
}

}  // namespace
}  // namespace campuswalk::engine
