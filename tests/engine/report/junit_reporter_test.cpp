#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/report/some_results.h"

namespace campuswalk::engine {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

// tests/tools/reports_test.py checks that reports are well-formed and follow the schema.

TEST(JunitReporter, HasASuitePerFileAndACasePerWalk) {
    WalkResult kiosk = failed_result("visit");
    kiosk.project = "kiosk";
    kiosk.repetition = 1;
    EXPECT_EQ(written("junit", {{passed_result("visit"), kiosk, skipped_result("lift")}}),
              R"(<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="campuswalk" tests="3" failures="1" errors="0" time="8.000">
  <testsuite name="walks/visit.walk.yaml" tests="2" failures="1" errors="0" time="8.000" skipped="0">
    <testcase name="visit" classname="walks/visit.walk.yaml" time="4.000" />
    <testcase name="visit kiosk #1" classname="walks/visit.walk.yaml" time="4.000">
      <failure type="sequence" message="popup.open library never came; last was &quot;ray.exit library/walls&quot;">walks/visit.walk.yaml:12:5: error sequence: popup.open library never came; last was "ray.exit library/walls"
at 4.050 s, 0.333,-0.125,-7.310, facing 45.0 degrees; in or near library; nearest library/walls, 0.42 m away
000240    4.000000 ray.enter library/walls
000243    4.050000 ray.exit library/walls
</failure>
      <system-out>[[ATTACHMENT|visit/failure-above.png]]
</system-out>
    </testcase>
  </testsuite>
  <testsuite name="walks/lift.walk.yaml" tests="1" failures="0" errors="0" time="0.000" skipped="1">
    <testcase name="lift" classname="walks/lift.walk.yaml" time="0.000">
      <skipped message="the lift is out of order" />
    </testcase>
  </testsuite>
</testsuites>
)");
}

TEST(JunitReporter, DistinguishesErrorsFromFailures) {
    const std::string text = written("junit", mixed_report());
    EXPECT_THAT(text,
                HasSubstr("<error type=\"bad_input\" message=\"walks/typo.walk.yaml:3:1: error bad-value: "
                          "speed must be > 0\">"));
    EXPECT_THAT(text, ContainsRegex("<error type=\"broken\" message=\"[^\"]+\">"));
    EXPECT_THAT(text, ContainsRegex("<error type=\"interrupted\" message=\"[^\"]+\">"));
    EXPECT_THAT(text, ContainsRegex("<failure type=\"xfail\" message=\"[^\"]+, but passed\">"));
    EXPECT_THAT(text, HasSubstr("tests=\"9\" failures=\"2\" errors=\"3\""));
}

TEST(JunitReporter, ContainsOnlyCharactersThatXmlAllows) {
    const std::string text = written("junit", hostile_report());
    for (const char c : text) {
        EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t') << static_cast<int>(c);
    }
    EXPECT_THAT(text, Not(HasSubstr("<b>")));
    EXPECT_THAT(text, Not(HasSubstr("&#")));
}

}  // namespace
}  // namespace campuswalk::engine
