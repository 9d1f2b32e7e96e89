#include "config/loader/yaml/read_budget.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config/loader/load_run.h"
#include "tests/config/config_folder.h"

namespace campuswalk::config {
namespace {

using scene::DiagnosticList;

std::string repeated(const std::string& text, std::size_t times) {
    std::string all;
    for (std::size_t i = 0; i < times; ++i) {
        all += text;
    }
    return all;
}

TEST(ReadBudget, CountsWhatValuesBeginOrEndWith) {
    EXPECT_EQ(count_marks(""), 0U);
    EXPECT_EQ(count_marks("[a, b, c]"), 3U);
    EXPECT_EQ(count_marks("{a: 1, b: [2, -3]}"), 6U);
    EXPECT_EQ(count_marks("- a\n- b\n-"), 3U);
    EXPECT_EQ(count_marks("? a\n: b"), 2U);
    EXPECT_EQ(count_marks("a: &x 1\nb: *x\nc: !y z"), 6U);
    EXPECT_EQ(count_marks("well-known words, 10-12"), 1U);
}

TEST(ReadBudget, RefusesOneFileOfTooManyMarks) {
    ReadBudget budget;
    DiagnosticList diagnostics;
    EXPECT_TRUE(budget.admit(repeated("a,", kMaxMarks), "a.yaml", diagnostics));
    EXPECT_FALSE(diagnostics.has_errors());
    EXPECT_FALSE(budget.admit(repeated("a,", kMaxMarks + 1), "b.yaml", diagnostics));
    ASSERT_EQ(diagnostics.all().size(), 1U);
    EXPECT_EQ(diagnostics.all()[0].code.text(), "too-large");
    EXPECT_EQ(diagnostics.all()[0].mark.file, "b.yaml");
    EXPECT_THAT(diagnostics.all()[0].message, testing::HasSubstr("1500001"));
}

TEST(ReadBudget, CountsAllFilesOfARun) {
    const std::string commas = repeated("a,", 1'000'000);
    const std::string letters(8'000'000, 'a');
    for (const auto& [text, admitted] : {std::pair(commas, 30), std::pair(letters, 37)}) {
        ReadBudget budget;
        DiagnosticList diagnostics;
        for (int i = 0; i < admitted; ++i) {
            EXPECT_TRUE(budget.admit(text, "a.yaml", diagnostics)) << i;
        }
        EXPECT_FALSE(budget.admit(text, "b.yaml", diagnostics));
        EXPECT_EQ(diagnostics.all().size(), 1U);
    }
}

/// The walk, its campus and its avatar draw on one budget, and so do those of the next walk.
TEST(ReadBudget, IsSharedByTheFilesOfAllWalks) {
    const test::ConfigFolder folder;
    SearchPaths search;
    load_run(folder.path("a.walk.yaml"), search);
    const std::string almost_all = repeated("a,", 1'000'000);
    DiagnosticList diagnostics;
    for (int i = 0; i < 29; ++i) {
        search.budget->admit(almost_all, "a.yaml", diagnostics);
    }
    search.budget->admit(repeated("a,", 999'950), "a.yaml", diagnostics);
    EXPECT_FALSE(diagnostics.has_errors());
    EXPECT_THROW(load_run(folder.path("a.walk.yaml"), search), scene::InputError);
    EXPECT_NO_THROW(load_run(folder.path("a.walk.yaml"), SearchPaths{}));
}

}  // namespace
}  // namespace campuswalk::config
