#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/report/some_results.h"

namespace campuswalk::engine {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(MarkdownReporter, HasATableThenWhatFailedWithItsImages) {
    EXPECT_EQ(
        written(
            "markdown",
            {{passed_result("arrive"), failed_result("visit"), skipped_result("lift"), xfail_result("door")}},
            {.folder = "out"}),
        R"(## campuswalk: 2 passed \(1 by failing as expected\), 1 failed, 1 skipped\: 12.0 simulated seconds, 15.0 m

| | walk | time | distance | |
|---|---|--:|--:|---|
| ❌ | walks/visit.walk.yaml | 4.0 s | 5.0 m | popup.open library never came; last was "ray.exit library/walls" |
| ✅ | walks/arrive.walk.yaml | 4.0 s | 5.0 m |  |
| ⏭️ skipped | walks/lift.walk.yaml | 0.0 s | 0.0 m | the lift is out of order |
| ✅ xfail | walks/door.walk.yaml | 4.0 s | 5.0 m | the door is too narrow |

### walks/visit.walk.yaml

- walks/visit.walk.yaml\:12\:5\: error sequence\: popup.open library never came; last was "ray.exit library/walls"
  at 4.050 s, 0.333,-0.125,-7.310, facing 45.0 degrees; in or near library; nearest library/walls, 0.42 m away

- failure from above: out/visit/failure-above.png
)");
}

TEST(MarkdownReporter, ShowsImagesThatHaveAnAddress) {
    WalkResult result = failed_result("visit");
    result.artifacts[0].path = "a b/<x>).png";
    const std::string text =
        written("markdown", {{result}}, {.folder = "out", .images_url = "https://files.example.org/17/"});
    EXPECT_THAT(
        text, HasSubstr("![failure from above](<https://files.example.org/17/out/a%20b/%3Cx%3E%29.png>)\n"));
}

TEST(MarkdownReporter, ShowsHostileTextAsItIs) {
    WalkResult result = failed_result("visit");
    result.failures[0].message = "a | b <img src=x> [x](https://x) @everyone\n# title";
    const std::string text = written("markdown", {{result}});
    EXPECT_THAT(text, HasSubstr(R"(a \| b \<img src=x\> \[x\]\(https\://x\) \@everyone\\n\# title)"));
    for (const std::string bare : {" <img", "](https", " @", "\n# "}) {
        EXPECT_THAT(text, Not(HasSubstr(bare)));
    }
    EXPECT_FALSE(written("markdown", hostile_report()).empty());
}

TEST(MarkdownReporter, IsShortForManyWalks) {
    RunReport many;
    many.results.assign(2000, passed_result("arrive"));
    many.results.back() = failed_result("visit");
    const std::string text = written("markdown", many);
    EXPECT_LT(text.size(), 100'000U);
    EXPECT_THAT(text, HasSubstr("… and 1500 more."));
    EXPECT_THAT(text, HasSubstr("| ❌ | walks/visit.walk.yaml"));  // though it was the last
    many.results.assign(2000, failed_result("visit"));
    EXPECT_LT(written("markdown", many).size(), 200'000U);
}

}  // namespace
}  // namespace campuswalk::engine
