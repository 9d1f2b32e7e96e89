#include <string>

#include <gtest/gtest.h>

#include "scene/base/glob.h"

namespace campuswalk::scene {
namespace {

TEST(GlobMatches, PlainNamesMatchThemselvesOnly) {
    EXPECT_TRUE(glob_matches("library", "library"));
    EXPECT_FALSE(glob_matches("library", "library_2"));
    EXPECT_FALSE(glob_matches("library", "old_library"));
    EXPECT_FALSE(glob_matches("library", "Library"));
    EXPECT_TRUE(glob_matches("", ""));
    EXPECT_FALSE(glob_matches("", "a"));
}

TEST(GlobMatches, StarMatchesAnyNumberOfCharacters) {
    EXPECT_TRUE(glob_matches("*", ""));
    EXPECT_TRUE(glob_matches("*", "anything at all"));
    EXPECT_TRUE(glob_matches("library_*", "library_"));
    EXPECT_TRUE(glob_matches("*_walls", "library_walls"));
    EXPECT_TRUE(glob_matches("a*b*c", "aXbYbZc"));
    EXPECT_FALSE(glob_matches("a*b*c", "aXbYbZ"));
    EXPECT_TRUE(glob_matches("**x**", "x"));
}

TEST(GlobMatches, QuestionMarkMatchesExactlyOne) {
    EXPECT_TRUE(glob_matches("tree_??", "tree_07"));
    EXPECT_FALSE(glob_matches("tree_??", "tree_7"));
    EXPECT_FALSE(glob_matches("tree_??", "tree_007"));
}

TEST(GlobMatches, ClassesSupportRangesAndNegation) {
    EXPECT_TRUE(glob_matches("room_[a-c1]", "room_b"));
    EXPECT_TRUE(glob_matches("room_[a-c1]", "room_1"));
    EXPECT_FALSE(glob_matches("room_[a-c1]", "room_d"));
    EXPECT_TRUE(glob_matches("room_[!a-c]", "room_d"));
    EXPECT_FALSE(glob_matches("room_[!a-c]", "room_a"));
    EXPECT_TRUE(glob_matches("[]x]", "]"));
    EXPECT_TRUE(glob_matches("[a-]", "-"));
}

TEST(GlobMatches, SpecialCharactersCanBeLiteral) {
    EXPECT_TRUE(glob_matches("nodes[3", "nodes[3"));  // never closed: stands for itself
    EXPECT_FALSE(glob_matches("nodes[3]", "nodes[3]"));
    EXPECT_TRUE(glob_matches("nodes[3]", "nodes3"));
    EXPECT_TRUE(glob_matches("nodes\\[3]", "nodes[3]"));
    EXPECT_TRUE(glob_matches("\\*", "*"));
    EXPECT_FALSE(glob_matches("\\*", "a"));
}

TEST(GlobFor, MatchesTheNameOnly) {
    for (const std::string name : {"door", "*", "a?b", "nodes[3]", "[!x]", "\\", "a\\*", "Tür [1] *"}) {
        EXPECT_TRUE(glob_matches(glob_for(name), name)) << name;
        EXPECT_FALSE(glob_matches(glob_for(name), name + "x")) << name;
        EXPECT_FALSE(glob_matches(glob_for(name), "x" + name)) << name;
    }
    for (const std::string name : {"line\nend", "tab\t*", "B\xe2timent", "\x7f\xc3"}) {
        EXPECT_TRUE(glob_matches(glob_for(name), name)) << name;
        EXPECT_EQ(glob_for(name).find_first_of("\n\t\xe2\x7f"), std::string::npos);
    }
    EXPECT_FALSE(glob_matches(glob_for("*"), "a"));
    EXPECT_FALSE(glob_matches(glob_for("nodes[3]"), "nodes3"));
}

TEST(GlobMatches, HostilePatternsTerminate) {
    std::string pattern;
    for (int i = 0; i < 200; ++i) {
        pattern += "a*";
    }
    EXPECT_FALSE(glob_matches(pattern + "b", std::string(5000, 'a')));
}

TEST(GlobMatches, CountsWhatItLooksAt) {
    const auto compared = [](const std::string& glob, const std::string& name) {
        std::uint64_t count = 0;
        EXPECT_EQ(glob_matches(glob, name, count), glob_matches(glob, name));
        return count;
    };
    EXPECT_EQ(compared("library", "library"), 7U);
    EXPECT_EQ(compared("library", "chapel"), 1U);
    EXPECT_EQ(compared("*b", std::string(1000, 'a')), 1000U);
    EXPECT_GE(compared("*[" + std::string(1000, 'b') + "]", std::string(1000, 'a')), 1'000'000U);
}

}  // namespace
}  // namespace campuswalk::scene
