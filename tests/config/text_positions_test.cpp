#include "config/loader/text_positions.h"

#include <string>

#include <gtest/gtest.h>

namespace campuswalk::config {
namespace {

/// "line:column".
std::string at(std::string_view text, int offset) {
    const TextPosition position = TextPositions(text).of(offset);
    return std::to_string(position.line) + ":" + std::to_string(position.column);
}

std::string null_at(std::string_view text, std::string_view before) {
    const auto offset = static_cast<int>(text.find(before) + before.size());
    const TextPosition position = TextPositions(text).of_null(offset);
    return std::to_string(position.line) + ":" + std::to_string(position.column);
}

TEST(TextPositions, CountFromOne) {
    EXPECT_EQ(at("ab\ncd\n", 0), "1:1");
    EXPECT_EQ(at("ab\ncd\n", 1), "1:2");
    EXPECT_EQ(at("ab\ncd\n", 2), "1:3");
    EXPECT_EQ(at("ab\ncd\n", 3), "2:1");
    EXPECT_EQ(at("ab\ncd\n", 6), "3:1");
}

TEST(TextPositions, TakeOffsetsOutsideForTheEnds) {
    EXPECT_EQ(at("ab", -5), "1:1");
    EXPECT_EQ(at("ab", 500), "1:3");
    EXPECT_EQ(at("", 3), "1:1");
}

TEST(TextPositions, CountCharactersNotBytes) {
    const std::string text = "总图: é x";
    EXPECT_EQ(at(text, static_cast<int>(text.find('x'))), "1:7");
}

TEST(TextPositions, CountThroughLongLines) {
    std::string text = "a: [\n";
    for (int i = 0; i < 3000; ++i) {
        text += "é";
    }
    for (int i = 0; i <= 3000; i += 7) {
        EXPECT_EQ(at(text, 5 + 2 * i), "2:" + std::to_string(i + 1));
    }
}

TEST(TextPositions, PutEmptyValuesAtTheirDash) {
    EXPECT_EQ(null_at("a:\n  - b\n  -   # nothing\n\n  - c\n", "nothing\n\n  "), "3:3");
    EXPECT_EQ(null_at("a:\n  - b\n  -\n", "b\n  -\n"), "3:3");
}

TEST(TextPositions, LeaveSpelledNullsWhereTheyAre) {
    EXPECT_EQ(null_at("a:\n  - b\n  - ~\n", "b\n  - "), "3:5");
    EXPECT_EQ(null_at("- a\n- null # here\n", "a\n- "), "2:3");
}

}  // namespace
}  // namespace campuswalk::config
