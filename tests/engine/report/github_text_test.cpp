#include "engine/report/github_text.h"

#include <gtest/gtest.h>

namespace campuswalk::engine {
namespace {

TEST(GitHubText, EscapesEachLineOfAMessage) {
    EXPECT_EQ(github_escaped("a%\n::b\x1b,\n", true), "a%25%0A\\x3a%3Ab\\x1b%2C%0A");
    EXPECT_EQ(github_escaped("\n##[x]", false), "%0A\\x23#[x]");
    EXPECT_EQ(github_escaped(std::string(1'000'000, '\n'), false).size(), 3'000'000U)
        << "one call for each overflows";
}

}  // namespace
}  // namespace campuswalk::engine
