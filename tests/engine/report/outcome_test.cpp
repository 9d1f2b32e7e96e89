#include "engine/report/outcome.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/says.h"

namespace campuswalk::engine {
namespace {

using support::mentions;

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

TEST(OutcomeOfFailures, IsTheWalksOwnUnlessItIsExpectedToFail) {
    EXPECT_EQ(outcome_of_failures({}, {}).outcome, Outcome::passed);
    const EvaluatedWalk evaluated = outcome_of_failures({failure("never")}, {});
    EXPECT_EQ(evaluated.outcome, Outcome::failed);
    EXPECT_EQ(evaluated.failures.size(), 1U);
}

TEST(OutcomeOfFailures, EachFailureOfACodeCanCount) {
    const std::vector<Failure> twice = {failure("near"), failure("near")};
    EXPECT_EQ(outcome_of_failures(twice, xfail({"near"})).outcome, Outcome::passed);
    EXPECT_EQ(outcome_of_failures(twice, xfail({"near"}), true).outcome, Outcome::failed);
    EXPECT_EQ(outcome_of_failures(twice, xfail({"near", "near"}), true).outcome, Outcome::passed);
    EXPECT_EQ(outcome_of_failures({failure("near")}, xfail({"near", "near"}), true).outcome, Outcome::failed);
    EXPECT_EQ(outcome_of_failures(twice, xfail(), true).outcome, Outcome::passed) << "in any way";
}

TEST(OutcomeOfFailures, XfailPassesIfTheWalkFails) {
    EXPECT_EQ(outcome_of_failures({failure("never")}, xfail()).outcome, Outcome::passed);
    const EvaluatedWalk evaluated =
        outcome_of_failures({failure("near"), failure("never"), failure("near")}, xfail({"never", "near"}));
    EXPECT_EQ(evaluated.outcome, Outcome::passed) << "in any order and number";
    EXPECT_EQ(evaluated.failures.size(), 3U);
}

TEST(OutcomeOfFailures, XfailFailsIfTheWalkPasses) {
    EXPECT_THAT(message_of({}, xfail()), mentions({"passed"}));
    EXPECT_THAT(message_of({}, xfail({"never"}, "the door is locked")),
                mentions({"never", "the door is locked", "passed"}));
}

TEST(OutcomeOfFailures, XfailTakesNoFailureThatIsALack) {
    for (const std::string lack :
         {"golden-missing", "golden-unreadable", "snapshot-missing", "not-evaluated", "route-unknown"}) {
        EXPECT_THAT(message_of({failure(lack)}, xfail()), mentions({"can't be evaluated", lack}));
        EXPECT_THAT(message_of({failure(lack)}, xfail({lack})), mentions({"can't be evaluated", lack}));
        EXPECT_THAT(message_of({failure("near"), failure(lack)}, xfail({"near"})),
                    mentions({"can't be evaluated: " + lack}));
        EXPECT_EQ(outcome_of_failures({failure(lack)}, {}).outcome, Outcome::failed);
        EXPECT_THAT(failure_codes(), testing::Not(testing::Contains(lack)));
    }
}

TEST(OutcomeOfFailures, XfailFailsUnlessTheCodesAreThoseExpected) {
    EXPECT_THAT(message_of({failure("blocked")}, xfail({"never"})), mentions({"never", "failed", "blocked"}));
    EXPECT_THAT(message_of({failure("never"), failure("blocked")}, xfail({"never"})),
                mentions({"never", "failed", "blocked, never"}));
    EXPECT_THAT(message_of({failure("never")}, xfail({"never", "blocked"})),
                mentions({"blocked, never", "failed", "never"}));
}

}  // namespace
}  // namespace campuswalk::engine
