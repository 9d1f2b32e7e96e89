#include "tools/campuswalk/init/ci_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace campuswalk::tools::init {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

const std::string kCommit = "0123456789abcdef0123456789abcdef01234567";

std::string text_of(Service service, const Publication& from) {
    return ci_file(service, from, 12)->text;
}

TEST(CiFiles, APublishedBuildIsNamedByItsCommit) {
    EXPECT_THAT(text_of(Service::github, {"owner/name", kCommit, "1.2.3"}),
                AllOf(HasSubstr("- uses: owner/name@" + kCommit +
                                " # v1.2.3\n        with:\n          version: 1.2.3\n"),
                      HasSubstr("--min-cases=12\n"), Not(HasSubstr("vars.")), Not(HasSubstr("env")),
                      Not(ContainsRegex("@[A-Z]+@"))));
    EXPECT_THAT(text_of(Service::gitlab, {"owner/name", kCommit, "1.2.3"}),
                AllOf(HasSubstr("CAMPUSWALK: \"https://github.com/owner/name/releases/download/v1.2.3/"
                                "campuswalk_1.2.3_amd64.deb\""),
                      HasSubstr("--min-cases=12 ")));
}

TEST(CiFiles, WhatABuildDoesNotKnowIsToBeFilledIn) {
    const std::string nothing = text_of(Service::github, {"", "", "1.2.3"});
    EXPECT_THAT(nothing, AllOf(HasSubstr("  CAMPUSWALK: \"\" "), HasSubstr("  CAMPUSWALK_COMMIT: \"\" ")));
    EXPECT_EQ(text_of(Service::github, {"owner/name", "", "1.2.3"}), nothing);
    EXPECT_THAT(text_of(Service::github, {"", kCommit, "1.2.3"}),
                HasSubstr("  CAMPUSWALK_COMMIT: \"" + kCommit + "\" "));
    EXPECT_THAT(text_of(Service::gitlab, {"", kCommit, "1.2.3"}), HasSubstr("    CAMPUSWALK: \"\" "));
}

}  // namespace
}  // namespace campuswalk::tools::init
