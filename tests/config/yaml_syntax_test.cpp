#include "config/loader/yaml/yaml_syntax.h"

#include <gtest/gtest.h>

namespace campuswalk::config {
namespace {

TEST(Explained, ReturnsUnknownMessagesUnchanged) {
    EXPECT_EQ(explained("something else"), "something else");
    EXPECT_NE(explained("end of map not found"), "end of map not found");
}

TEST(UnclosedQuote, IsSearchedToTheEndOfTheFile) {
    EXPECT_TRUE(is_quote_unclosed("'abc\nb: c\n", 0));
    EXPECT_TRUE(is_quote_unclosed("\"abc\\\"", 0));
    EXPECT_TRUE(is_quote_unclosed("'it''s", 0));
    EXPECT_TRUE(is_quote_unclosed("a: \"", 3));
    EXPECT_TRUE(is_quote_unclosed("&name !  'x", 0));
}

TEST(UnclosedQuote, IsNotFoundWhereTheQuoteCloses) {
    EXPECT_FALSE(is_quote_unclosed("'abc'", 0));
    EXPECT_FALSE(is_quote_unclosed("''", 0));
    EXPECT_FALSE(is_quote_unclosed("'it''s'", 0));
    EXPECT_FALSE(is_quote_unclosed(R"("a\\")", 0));
    EXPECT_FALSE(is_quote_unclosed(R"("a\"b")", 0));
    EXPECT_FALSE(is_quote_unclosed("'two\nlines'", 0));
    EXPECT_FALSE(is_quote_unclosed("&name 'x'", 0));
}

TEST(UnclosedQuote, IsFoundOnlyAtTheStartOfTheValue) {
    EXPECT_FALSE(is_quote_unclosed("it's", 0));
    EXPECT_FALSE(is_quote_unclosed("|\n  it's\n", 0));
    EXPECT_FALSE(is_quote_unclosed("&name", 0));
    EXPECT_FALSE(is_quote_unclosed("", 0));
    EXPECT_FALSE(is_quote_unclosed("'", 5));
}

}  // namespace
}  // namespace campuswalk::config
