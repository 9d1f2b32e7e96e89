#include "config/loader/yaml/wording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace campuswalk::config {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

TEST(InQuotes, JoinsLinesIntoOne) {
    EXPECT_EQ(in_quotes("word"), "'word'");
    EXPECT_EQ(in_quotes("two\nlines\t!"), "'two lines !'");
}

TEST(InQuotes, CutsLongTextsBetweenCharacters) {
    EXPECT_EQ(in_quotes(std::string(60, 'x')), "'" + std::string(60, 'x') + "'");
    EXPECT_EQ(in_quotes(std::string(61, 'x')), "'" + std::string(60, 'x') + "…'");
    EXPECT_EQ(in_quotes(std::string(59, 'x') + "é"), "'" + std::string(59, 'x') + "…'");
}

TEST(Listed, CutsLongLists) {
    EXPECT_EQ(listed({}), "");
    EXPECT_EQ(listed({"a"}), "a");
    EXPECT_EQ(listed({"a", "b"}), "a, b");
    const std::string list = listed(std::vector<std::string>(26, "a"));
    EXPECT_TRUE(list.ends_with("a, a, …"));
}

TEST(Suggestion, FindsSingleTypos) {
    const std::vector<std::string> known = {"wait", "walk_to", "turn"};
    EXPECT_THAT(suggestion("wiat", known), HasSubstr("'wait'"));       // swapped
    EXPECT_THAT(suggestion("walkto", known), HasSubstr("'walk_to'"));  // left out
    EXPECT_THAT(suggestion("turnn", known), HasSubstr("'turn'"));      // doubled
    EXPECT_THAT(suggestion("torn", known), HasSubstr("'turn'"));       // replaced
    EXPECT_EQ(suggestion("jump", known), "");
    EXPECT_EQ(suggestion("", known), "");
}

TEST(Suggestion, IgnoresSingleLettersAndVeryLongWords) {
    EXPECT_EQ(suggestion("w", {"x", "y"}), "");
    const std::string word(65, 'a');
    EXPECT_EQ(suggestion(word, {word + "a"}), "");
}

TEST(SuggestionOrList, ListsKnownWordsWhenNoneIsSimilar) {
    EXPECT_THAT(suggestion_or_list("jump", {"wait", "turn"}), EndsWith(": wait, turn"));
    EXPECT_EQ(suggestion_or_list("jump", {}), "");
}

TEST(ShownNumber, HasNoExponentAndNoTrailingZeros) {
    EXPECT_EQ(shown_number(0.0), "0");
    EXPECT_EQ(shown_number(1e7), "10000000");
    EXPECT_EQ(shown_number(0.05), "0.05");
    EXPECT_EQ(shown_number(-2.5), "-2.5");
    EXPECT_EQ(shown_number(1e-7), "0.0000001");
}

}  // namespace
}  // namespace campuswalk::config
