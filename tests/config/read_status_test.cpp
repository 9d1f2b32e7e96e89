#include "config/loader/walk/read_walk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"
#include "tests/support/says.h"

namespace campuswalk::config {
namespace {

using engine::WalkStatus;
using support::says;
using testing::ElementsAre;

/// Keys above a walk's steps, from line 2 on.
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

TEST_F(ReadStatus, ReadsEveryStatusAndDefaultsToRun) {
    EXPECT_EQ(read("tags: []").status.kind, WalkStatus::Kind::run);
    EXPECT_EQ(read("status: run").status.kind, WalkStatus::Kind::run);
    EXPECT_EQ(read("status: skip").status.kind, WalkStatus::Kind::skip);
    EXPECT_EQ(read("status: only").status.kind, WalkStatus::Kind::only);
    EXPECT_EQ(read("status: xfail").status.kind, WalkStatus::Kind::xfail);
}

TEST_F(ReadStatus, ReadsReasonAndFailures) {
    const WalkStatus status =
        read("status: {is: xfail, because: no ramp yet, failures: [blocked, not-fell]}").status;
    EXPECT_EQ(status.kind, WalkStatus::Kind::xfail);
    EXPECT_EQ(status.reason, "no ramp yet");
    EXPECT_THAT(status.codes, ElementsAre("blocked", "not-fell"));
    EXPECT_EQ(status.mark.line, 2);
    EXPECT_THAT(read("status: {is: xfail, failures: timeout}").status.codes, ElementsAre("timeout"));
    EXPECT_EQ(read("status: {is: skip, because: it is winter}").status.reason, "it is winter");
}

TEST_F(ReadStatus, DiagnosesUnknownStatusesAndFailures) {
    EXPECT_THAT(about("status: xfial"),
                ElementsAre(says("a.walk.yaml:2:9: error bad-value", {"'status'", "'xfial'", "'xfail'"})));
    EXPECT_THAT(about("status: {because: a, failures: []}"),
                ElementsAre(says("a.walk.yaml:2:9: error missing-key", {"'status'", "'is'"}),
                            says("a.walk.yaml:2:32: error bad-value", {"'failures'"}),
                            says("a.walk.yaml:2:32: error bad-value", {"'failures'"})));
    EXPECT_THAT(about("status: {is: xfail, failures: [stcuk]}"),
                ElementsAre(says("a.walk.yaml:2:32: error bad-value", {"'stcuk'", "'stuck'"})));
}

TEST_F(ReadStatus, ReadsTags) {
    EXPECT_THAT(read("tags: [smoke, night-shift]").tags, ElementsAre("smoke", "night-shift"));
    EXPECT_THAT(read("tags: smoke").tags, ElementsAre("smoke"));
    EXPECT_THAT(about("tags: [Smoke, a, a]"),
                ElementsAre(says("a.walk.yaml:2:8: error bad-value", {"'Smoke'"}),
                            says("a.walk.yaml:2:18: error duplicate-name", {"'a'"})));
}

TEST_F(ReadStatus, ReadsTheTimeout) {
    EXPECT_EQ(read("timeout: 12.5").timeout, 12.5);
    EXPECT_FALSE(read("tags: []").timeout);
    EXPECT_THAT(about("timeout: 0"),
                ElementsAre(says("a.walk.yaml:2:10: error bad-value", {"'timeout'", "'0'"})));
}

}  // namespace
}  // namespace campuswalk::config
