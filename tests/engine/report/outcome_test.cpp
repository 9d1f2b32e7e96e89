#include "engine/report/outcome.h"

#include <gtest/gtest.h>

namespace campuswalk::engine {
namespace {

Failure failure(const std::string& code) {
    return {{"a.walk.yaml", 9, 5}, code, "it was not so", {}};
}

WalkStatus xfail(const std::vector<std::string>& codes = {}, const std::string& reason = "") {
    return {{"a.walk.yaml", 3, 9}, WalkStatus::Kind::xfail, reason, codes};
}

/// The message of an xfail that did not fail as it should have.
std::string diagnostic_of(const std::vector<Failure>& failures, const WalkStatus& status) {
    const EvaluatedWalk evaluated = outcome_of_evaluators(failures, status);
    EXPECT_EQ(evaluated.outcome, Outcome::failed);
    EXPECT_EQ(evaluated.failures.size(), failures.size() + 1) << "the walk's own are kept";
    EXPECT_EQ(evaluated.failures.back().code, "xfail");
    EXPECT_EQ(evaluated.failures.back().mark.line, 3) << "at the status";
    return evaluated.failures.back().message;
}

TEST(EvaluatorOutcome, IsWhatTheWalkWasUnlessItShouldFail) {
    EXPECT_EQ(outcome_of_evaluators({}, {}).outcome, Outcome::passed);
    const EvaluatedWalk evaluated = outcome_of_evaluators({failure("never")}, {});
    EXPECT_EQ(evaluated.outcome, Outcome::failed);
    EXPECT_EQ(evaluated.failures.size(), 1U);
}

TEST(EvaluatorOutcome, AnXfailPassesWhenItFails) {
    EXPECT_EQ(outcome_of_evaluators({failure("never")}, xfail()).outcome, Outcome::passed);
    const EvaluatedWalk evaluated =
        outcome_of_evaluators({failure("near"), failure("never"), failure("near")}, xfail({"never", "near"}));
    EXPECT_EQ(evaluated.outcome, Outcome::passed) << "in any order and number";
    EXPECT_EQ(evaluated.failures.size(), 3U);
}

TEST(EvaluatorOutcome, AnXfailThatPassesFails) {
    EXPECT_EQ(diagnostic_of({}, xfail()), "expected to fail, but passed");
    EXPECT_EQ(diagnostic_of({}, xfail({"never"}, "the door is locked")),
              "expected to fail with never because the door is locked, but passed");
}

TEST(EvaluatorOutcome, AnXfailFailsForNoOtherReason) {
    EXPECT_EQ(diagnostic_of({failure("blocked")}, xfail({"never"})),
              "expected to fail with never, but failed with blocked");
    EXPECT_EQ(diagnostic_of({failure("never"), failure("blocked")}, xfail({"never"})),
              "expected to fail with never, but failed with blocked, never");
    EXPECT_EQ(diagnostic_of({failure("never")}, xfail({"never", "blocked"})),
              "expected to fail with blocked, never, but failed with never");
}

}  // namespace
}  // namespace campuswalk::engine
