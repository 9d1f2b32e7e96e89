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
std::string complaint_of(const std::vector<Failure>& failures, const WalkStatus& status) {
    const JudgedWalk judged = judge_outcome(failures, status);
    EXPECT_EQ(judged.outcome, Outcome::failed);
    EXPECT_EQ(judged.failures.size(), failures.size() + 1) << "the walk's own are kept";
    EXPECT_EQ(judged.failures.back().code, "xfail");
    EXPECT_EQ(judged.failures.back().mark.line, 3) << "at the status";
    return judged.failures.back().message;
}

TEST(JudgeOutcome, IsWhatTheWalkWasUnlessItShouldFail) {
    EXPECT_EQ(judge_outcome({}, {}).outcome, Outcome::passed);
    const JudgedWalk judged = judge_outcome({failure("never")}, {});
    EXPECT_EQ(judged.outcome, Outcome::failed);
    EXPECT_EQ(judged.failures.size(), 1U);
}

TEST(JudgeOutcome, AnXfailPassesWhenItFails) {
    EXPECT_EQ(judge_outcome({failure("never")}, xfail()).outcome, Outcome::passed);
    const JudgedWalk judged =
        judge_outcome({failure("near"), failure("never"), failure("near")}, xfail({"never", "near"}));
    EXPECT_EQ(judged.outcome, Outcome::passed) << "in any order and number";
    EXPECT_EQ(judged.failures.size(), 3U);
}

TEST(JudgeOutcome, AnXfailThatPassesFails) {
    EXPECT_EQ(complaint_of({}, xfail()), "expected to fail, but passed");
    EXPECT_EQ(complaint_of({}, xfail({"never"}, "the door is locked")),
              "expected to fail with never because the door is locked, but passed");
}

TEST(JudgeOutcome, AnXfailFailsForNoOtherReason) {
    EXPECT_EQ(complaint_of({failure("blocked")}, xfail({"never"})),
              "expected to fail with never, but failed with blocked");
    EXPECT_EQ(complaint_of({failure("never"), failure("blocked")}, xfail({"never"})),
              "expected to fail with never, but failed with blocked, never");
    EXPECT_EQ(complaint_of({failure("never")}, xfail({"never", "blocked"})),
              "expected to fail with blocked, never, but failed with never");
}

}  // namespace
}  // namespace campuswalk::engine
