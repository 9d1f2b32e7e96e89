#include "engine/report/report_paths.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/report/result_json.h"
#include "tests/engine/report/some_results.h"

namespace campuswalk::engine {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ReportPaths, AreLeftAloneInTheRoot) {
    EXPECT_EQ(to_json_line(with_paths_in_repository("", full_result())), to_json_line(full_result()));
    EXPECT_EQ(to_json_line(with_paths_in_run("", full_result())), to_json_line(full_result()));
}

TEST(ReportPaths, BeginAtTheRoot) {
    const WalkResult placed = with_paths_in_repository("campus/tests", full_result());
    EXPECT_EQ(placed.id, "campus/tests/walks/visit.walk.yaml kiosk #2");
    EXPECT_EQ(placed.file, "campus/tests/walks/visit.walk.yaml");
    EXPECT_EQ(placed.config, "campus/tests/walks.config.yaml");
    EXPECT_EQ(placed.failures[0].mark.file, "campus/tests/walks/visit.walk.yaml");
    EXPECT_EQ(placed.failures[0].mark.line, 12);
    EXPECT_EQ(to_string(placed.diagnostics[0]),
              "campus/tests/walks/visit.walk.yaml:3:1: error bad-value: speed must be > 0");
    EXPECT_EQ(placed.artifacts[0].path, "visit/gate.png");  // below the output folder, as ever
}

TEST(ReportPaths, AboveTheStartHaveNoDots) {
    WalkResult result = passed_result("visit");
    result.id = result.file = "../walks/visit.walk.yaml";
    result.failures = {{{"../../shared/stairs.steps.yaml", 2, 1}, "blocked", "…"}};
    const WalkResult placed = with_paths_in_repository("a/b", result);
    EXPECT_EQ(placed.file, "a/walks/visit.walk.yaml");
    EXPECT_EQ(placed.failures[0].mark.file, "shared/stairs.steps.yaml");
    EXPECT_EQ(to_json_line(with_paths_in_run("a/b", placed)), to_json_line(result));
}

TEST(ReportPaths, OfAReportLeadBackToTheRun) {
    for (const WalkResult& result : mixed_report().results) {
        for (const char* start : {"a", "a/b", "a b/ä"}) {
            const WalkResult placed = with_paths_in_repository(start, result);
            EXPECT_NE(placed.file, result.file);
            EXPECT_EQ(to_json_line(with_paths_in_run(start, placed)), to_json_line(result));
        }
    }
}

TEST(ReportPaths, WhatIsNoPathStays) {
    WalkResult result = bad_input_result("typo");
    result.config = "";
    result.diagnostics = {{{}, {"--project", 0, 0}, "bad-value", "there is no project x"},
                          {{}, {}, {}, "killed: error out of memory"}};
    result.failures = {{{}, "stopped", "…"}};
    const WalkResult placed = with_paths_in_repository("a", result);
    EXPECT_EQ(placed.config, "");
    EXPECT_EQ(placed.diagnostics, result.diagnostics);
    EXPECT_EQ(placed.failures[0].mark.file, "");
}

TEST(ReportPaths, OfEveryReporterBeginAtTheRoot) {
    const ReportStyle style{.folder = "campus/out", .start = "campus"};
    for (const std::string& name : reporters_of_results()) {
        if (name == "dot") {  // in which passed walks have no names
            continue;
        }
        const std::string text = written(name, mixed_report(), style);
        EXPECT_THAT(text, HasSubstr("campus/walks/visit.walk.yaml")) << name;
        for (const std::string before : {"\"", "=", " ", "\n", ">"}) {
            EXPECT_THAT(text, Not(HasSubstr(before + "walks/"))) << name;
        }
    }
}

TEST(ReportPaths, JunitAttachmentsAreInTheOutputFolder) {
    const std::string text =
        written("junit", {{failed_result("visit")}}, {.folder = "campus/out", .start = "campus"});
    EXPECT_THAT(text, HasSubstr("[[ATTACHMENT|campus/out/visit/failure-above.png]]"));
}

}  // namespace
}  // namespace campuswalk::engine
