#include "config/loader/read_status.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"

namespace campuswalk::config {
namespace {

using engine::WalkStatus;
using testing::ElementsAre;

/// What stands above a walk's steps, from line 2 on.
class ReadStatus : public testing::Test {
protected:
    test::Lines about(const std::string& keys) {
        return folder_.about_walk("campus: a.campus.yaml\n" + keys + "\nsteps: [{spawn: gate}]\n");
    }
    engine::Walk read(const std::string& keys) {
        EXPECT_THAT(about(keys), ElementsAre());
        return folder_.run().walk;
    }

    test::ConfigFolder folder_;
};

TEST_F(ReadStatus, IsToRunUnlessSaidOtherwise) {
    EXPECT_EQ(read("tags: []").status.kind, WalkStatus::Kind::run);
    EXPECT_EQ(read("status: run").status.kind, WalkStatus::Kind::run);
    EXPECT_EQ(read("status: skip").status.kind, WalkStatus::Kind::skip);
    EXPECT_EQ(read("status: only").status.kind, WalkStatus::Kind::only);
    EXPECT_EQ(read("status: xfail").status.kind, WalkStatus::Kind::xfail);
}

TEST_F(ReadStatus, HasAReasonAndFailures) {
    const WalkStatus status =
        read("status: {is: xfail, because: no ramp yet, failures: [blocked, not-fell]}").status;
    EXPECT_EQ(status.kind, WalkStatus::Kind::xfail);
    EXPECT_EQ(status.reason, "no ramp yet");
    EXPECT_THAT(status.codes, ElementsAre("blocked", "not-fell"));
    EXPECT_EQ(status.mark.line, 2);
    EXPECT_THAT(read("status: {is: xfail, failures: timeout}").status.codes, ElementsAre("timeout"));
    EXPECT_EQ(read("status: {is: skip, because: it is winter}").status.reason, "it is winter");
}

TEST_F(ReadStatus, DiagnosesOthers) {
    EXPECT_THAT(
        about("status: xfial"),
        ElementsAre("a.walk.yaml:2:9: error bad-value: 'status' must be one of run, skip, only, xfail, "
                    "not 'xfial' (did you mean 'xfail'?)"));
    EXPECT_THAT(
        about("status: {because: a, failures: []}"),
        ElementsAre("a.walk.yaml:2:9: error missing-key: 'status' needs the key 'is'",
                    "a.walk.yaml:2:32: error bad-value: 'failures' needs at least one; leave it out if "
                    "any will do",
                    "a.walk.yaml:2:32: error bad-value: 'failures' are for walks that are xfail"));
    EXPECT_THAT(
        about("status: {is: xfail, failures: [stcuk]}"),
        ElementsAre(testing::AllOf(
            testing::StartsWith("a.walk.yaml:2:32: error bad-value: a failure must be one of blocked, "),
            testing::EndsWith(" not 'stcuk' (did you mean 'stuck'?)"))));
}

TEST_F(ReadStatus, ReadsTags) {
    EXPECT_THAT(read("tags: [smoke, night-shift]").tags, ElementsAre("smoke", "night-shift"));
    EXPECT_THAT(read("tags: smoke").tags, ElementsAre("smoke"));
    EXPECT_THAT(
        about("tags: [Smoke, a, a]"),
        ElementsAre("a.walk.yaml:2:8: error bad-value: a tag must be small letters, digits and single "
                    "hyphens, as in main-gate, not 'Smoke'",
                    "a.walk.yaml:2:18: error duplicate-name: the tag 'a' stands on line 2 already"));
}

TEST_F(ReadStatus, ReadsTheTimeOut) {
    EXPECT_EQ(read("timeout: 12.5").timeout, 12.5);
    EXPECT_FALSE(read("tags: []").timeout);
    EXPECT_THAT(
        about("timeout: 0"),
        ElementsAre("a.walk.yaml:2:10: error bad-value: 'timeout' must be more than 0 and at most 86400 "
                    "s, not '0'"));
}

}  // namespace
}  // namespace campuswalk::config
