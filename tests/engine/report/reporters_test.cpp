#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/report/result_json.h"
#include "tests/engine/report/some_results.h"

namespace campuswalk::engine {
namespace {

using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::ordered_json;

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

TEST(Reporters, AreCreatedByName) {
    for (const std::string& name : reporters_of_results()) {
        EXPECT_NE(make_reporter(name, [](std::string_view) {}), nullptr) << name;
    }
    EXPECT_EQ(make_reporter("lists", [](std::string_view) {}), nullptr);
}

TEST(Reporters, ThatOfHtmlComesFromTheProgram) {
    EXPECT_EQ(make_reporter("html", [](std::string_view) {}), nullptr);
    ReportStyle style;
    style.html = [](TextSink sink) { return make_reporter("tap", std::move(sink)); };
    EXPECT_NE(make_reporter(
                  "html", [](std::string_view) {}, style),
              nullptr);
}

TEST(Reporters, EndEveryReportWithANewline) {
    for (const std::string& name : reporters_of_results()) {
        for (const RunReport& report : {RunReport{}, mixed_report(), hostile_report()}) {
            const std::string text = written(name, report);
            EXPECT_TRUE(text.empty() || text.ends_with('\n')) << name;
        }
    }
}

TEST(Reporters, PropagateExceptionsOfTheirSink) {
    for (const std::string& name : reporters_of_results()) {
        const auto reporter =
            make_reporter(name, [](std::string_view) { throw std::runtime_error("disk full"); });
        const RunReport report = mixed_report();
        const auto run = [&] {
            reporter->begin(plan_of(report));
            for (const WalkResult& result : report.results) {
                reporter->result(result);
            }
            reporter->end(report);
        };
        EXPECT_THROW(run(), std::runtime_error) << name;
    }
}

TEST(ListReporter, PrintsOneLinePerCaseThenTheFailuresThenTheCounts) {
    const std::string text = written(
        "list",
        {{passed_result("arrive"), failed_result("visit"), skipped_result("lift"), xfail_result("door")}},
        {.folder = "out"});
    EXPECT_EQ(text, R"(pass  walks/arrive.walk.yaml                            4.0 s  5.0 m
FAIL  walks/visit.walk.yaml                             4.0 s  5.0 m
skip  walks/lift.walk.yaml                              the lift is out of order
xfail walks/door.walk.yaml                              4.0 s  5.0 m  the door is too narrow

1) walks/visit.walk.yaml
   walks/visit.walk.yaml:12:5: error sequence: popup.open library never came; last was "ray.exit library/walls"
     at 4.050 s, 0.333,-0.125,-7.310, facing 45.0 degrees; in or near library; nearest library/walls, 0.42 m away
     the last events before it:
       000240    4.000000 ray.enter library/walls
       000243    4.050000 ray.exit library/walls
   failure from above: out/visit/failure-above.png

2 passed (1 by failing as expected), 1 failed, 1 skipped: 12.0 simulated seconds, 15.0 m
)");
}

TEST(ListReporter, PrintsASceneOnceForFailuresOfOneTick) {
    WalkResult result = failed_result("visit");
    const Failure failure = result.failures[0];
    result.failures.push_back(failure);
    result.failures.push_back(failure);
    result.failures[2].scene.tick += 1;
    result.failures[2].scene.time += 1.0 / 60.0;
    const std::string text = written("list", {{result}});
    const auto count_of = [&](const std::string& part) {
        std::size_t count = 0;
        for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
            ++count;
        }
        return count;
    };
    EXPECT_EQ(count_of("walks/visit.walk.yaml:12:5: error "), 3U);
    EXPECT_EQ(count_of("at 4.050 s"), 1U);
    EXPECT_EQ(count_of("at 4.067 s"), 1U);
}

TEST(ListReporter, GivesTheReasonForOtherOutcomes) {
    const std::string text = written("list", mixed_report());
    EXPECT_THAT(text,
                HasSubstr("walks/wrong.walk.yaml\n   walks/wrong.walk.yaml:3:9: error xfail: expected to "
                          "fail because the door is too narrow, but passed\n\n"));
    EXPECT_THAT(text, HasSubstr("   walks/typo.walk.yaml:3:1: error bad-value: speed must be > 0\n"));
    EXPECT_THAT(text, ContainsRegex("walks/broken.walk.yaml\n   [a-z]"));
    EXPECT_THAT(text, ContainsRegex("walks/stopped.walk.yaml\n   [a-z]"));
    EXPECT_THAT(text,
                HasSubstr("\n3 passed (1 by failing as expected), 2 failed, 1 skipped, 1 with bad input, "
                          "1 broken, 1 interrupted: "));
}

TEST(ListReporter, OmitsExpectedOutcomesIfQuiet) {
    EXPECT_EQ(written("list", {{passed_result("arrive")}}, {.quiet = true}),
              "1 passed: 4.0 simulated seconds, 5.0 m\n");
    const std::string text = written("list", mixed_report(), {.quiet = true});
    EXPECT_THAT(text, Not(HasSubstr("arrive")));
    EXPECT_THAT(text, HasSubstr("walks/visit.walk.yaml:12:5: error sequence"));
}

TEST(ListReporter, UsesColorsOnlyOnRequest) {
    EXPECT_THAT(written("list", mixed_report()), Not(HasSubstr("\x1b")));
    std::string text = written("list", mixed_report(), {.color = true});
    EXPECT_THAT(text, HasSubstr("\x1b[31mFAIL  \x1b[0mwalks/visit.walk.yaml"));
    for (const std::string code : {"\x1b[31m", "\x1b[32m", "\x1b[33m", "\x1b[0m"}) {
        for (std::size_t at = text.find(code); at != std::string::npos; at = text.find(code)) {
            text.erase(at, code.size());
        }
    }
    EXPECT_EQ(text, written("list", mixed_report()));
}

TEST(DotReporter, PrintsOneCharacterPerCaseInLinesOfEighty) {
    EXPECT_EQ(lines_of(written("dot", mixed_report())).front(), "..FsxFEEI");
    RunReport many;
    many.results.assign(161, passed_result("arrive"));
    EXPECT_THAT(lines_of(written("dot", many)),
                ElementsAre(std::string(80, '.'), std::string(80, '.'), ".", "",
                            "161 passed: 644.0 simulated seconds, 805.0 m"));
}

TEST(DotReporter, PrintsEachCaseAsItEnds) {
    std::string text;
    const auto dots = make_reporter("dot", [&](std::string_view part) { text += part; });
    dots->begin({.cases = 2});
    dots->result(passed_result("a"));
    EXPECT_EQ(text, ".");
    dots->result(failed_result("b"));
    EXPECT_EQ(text, ".F");
}

TEST(TapReporter, PrintsVersion14) {
    EXPECT_EQ(written("tap", {{passed_result("arrive"), failed_result("visit"), skipped_result("lift"),
                               xfail_result("door")}}),
              R"(TAP version 14
1..4
ok 1 - walks/arrive.walk.yaml
not ok 2 - walks/visit.walk.yaml
  ---
  outcome: failed
  failures:
    - code: "sequence"
      message: "popup.open library never came; last was \"ray.exit library/walls\""
      file: "walks/visit.walk.yaml"
      line: 12
      column: 5
      place: "at 4.050 s, 0.333,-0.125,-7.310, facing 45.0 degrees; in or near library; nearest library/walls, 0.42 m away"
  ...
ok 3 - walks/lift.walk.yaml # SKIP the lift is out of order
not ok 4 - walks/door.walk.yaml # TODO the door is too narrow
  ---
  outcome: passed
  failures:
    - code: "sequence"
      message: "popup.open library never came; last was \"ray.exit library/walls\""
      file: "walks/door.walk.yaml"
      line: 12
      column: 5
      place: "at 4.050 s, 0.333,-0.125,-7.310, facing 45.0 degrees; in or near library; nearest library/walls, 0.42 m away"
  ...
)");
    EXPECT_EQ(written("tap", {}), "TAP version 14\n1..0\n");
}

TEST(TapReporter, PrintsOneTestPointPerCaseForAnyText) {
    std::size_t points = 0;
    for (const std::string& line : lines_of(written("tap", hostile_report()))) {
        const bool point = line.starts_with("ok ") || line.starts_with("not ok ");
        points += point ? 1U : 0U;
        EXPECT_TRUE(point || line.starts_with("  ") || line.starts_with("TAP ") || line == "1..4") << line;
    }
    EXPECT_EQ(points, 4U);
    const std::string first = lines_of(written("tap", hostile_report())).at(2);
    EXPECT_THAT(first, HasSubstr("\\#"));
    EXPECT_THAT(first, Not(HasSubstr(" #")));
}

TEST(GithubReporter, AnnotatesEveryFailureAtItsLine) {
    EXPECT_EQ(
        written("github", {{passed_result("arrive"), failed_result("visit"), bad_input_result("typo"),
                            xfail_result("door")}}),
        "::error file=walks/visit.walk.yaml,line=12,col=5,title=walks/visit.walk.yaml%3A sequence::"
        "popup.open library never came; last was \"ray.exit library/walls\"%0A"
        "at 4.050 s, 0.333,-0.125,-7.310, facing 45.0 degrees; in or near library; nearest library/walls, "
        "0.42 m away\n"
        "::error file=walks/typo.walk.yaml,line=3,col=1,title=walks/typo.walk.yaml%3A bad-value::"
        "speed must be > 0\n"
        "::notice title=campuswalk::2 passed (1 by failing as expected), 1 failed, 1 with bad input: "
        "12.0 simulated seconds, 15.0 m\n");
}

TEST(GithubReporter, EscapesTextThatLooksLikeACommand) {
    for (const std::string& line : lines_of(written("github", hostile_report()))) {
        EXPECT_TRUE(line.starts_with("::error file=") || line.starts_with("::notice title=campuswalk::"))
            << line;
    }
    WalkResult result = failed_result("a,b:c");
    result.failures[0].message = "50 %\nof it\r";
    const std::string text = written("github", {{result}});
    EXPECT_THAT(text, HasSubstr("file=walks/a%2Cb%3Ac.walk.yaml,line=12"));
    EXPECT_THAT(text, HasSubstr("::50 %25%0Aof it\\x0d%0A"));
}

TEST(JsonlReporter, PrintsAHeaderAndOneLinePerResult) {
    const RunReport report = mixed_report();
    const std::vector<std::string> lines = lines_of(written("jsonl", report));
    ASSERT_EQ(lines.size(), report.results.size() + 1);
    EXPECT_EQ(lines[0], R"({"campuswalk_results":6,"cases":9,"shard":1,"shards":1,"all_cases":9,)"
                        R"("contents":"0a1b","division":"2c3d",)"
                        R"("fingerprint":{"program":"","options":"","files":""},"start":""})");
    for (std::size_t i = 0; i < report.results.size(); ++i) {
        EXPECT_EQ(lines[i + 1], to_json_line(report.results[i]));
    }
}

TEST(JsonReporter, ContainsTheResultsAndTheirCounts) {
    const RunReport report = mixed_report();
    const Json json = Json::parse(written("json", report));
    EXPECT_EQ(json["campuswalk_report"], 1);
    EXPECT_EQ(json["plan"].dump(), to_json(plan_of(report)));
    EXPECT_EQ(json["summary"].dump(),
              R"({"passed":3,"failed":2,"skipped":1,"bad_input":1,"broken":1,"interrupted":1,)"
              R"("expected_failures":1,"not_evaluated":0,"simulated_seconds":20.0,"distance":25.0})");
    ASSERT_EQ(json["results"].size(), report.results.size());
    for (std::size_t i = 0; i < report.results.size(); ++i) {
        EXPECT_EQ(json["results"][i].dump(), to_json_line(report.results[i]));
    }
    EXPECT_EQ(Json::parse(written("json", {}))["results"], Json::array());
}

}  // namespace
}  // namespace campuswalk::engine
