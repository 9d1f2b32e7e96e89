#include "config/loader/values/number.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/dice.h"
#include "tests/support/effort.h"

namespace campuswalk::config {
namespace {

using support::Dice;
using testing::ContainsRegex;
using testing::HasSubstr;

constexpr double kHuge = std::numeric_limits<double>::max();
constexpr Range kAny{-kHuge, kHuge, false, ""};

std::string code_of(const char* text) {
    return std::string(parse_number(text, kAny).code.text());
}

/// An independent definition of a decimal number.
bool is_decimal(const std::string& text) {
    static const std::regex form(R"([+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?)");
    static const std::regex leading_zero(R"([+-]?0\d.*)");
    return std::regex_match(text, form) && !std::regex_match(text, leading_zero);
}

TEST(ParseNumber, AcceptsDecimalNumbers) {
    EXPECT_EQ(parse_number("0", kAny).value, 0.0);
    EXPECT_EQ(parse_number("-12.5", kAny).value, -12.5);
    EXPECT_EQ(parse_number("+3", kAny).value, 3.0);
    EXPECT_EQ(parse_number(".5", kAny).value, 0.5);
    EXPECT_EQ(parse_number("5.", kAny).value, 5.0);
    EXPECT_EQ(parse_number("0.25", kAny).value, 0.25);
    EXPECT_EQ(parse_number("1e3", kAny).value, 1000.0);
    EXPECT_EQ(parse_number("1.5E-2", kAny).value, 0.015);
}

TEST(ParseNumber, RefusesOtherNotations) {
    for (const char* text :
         {"",   "-",   "+",     ".",    "e5",   ".e5",  "1e",  "1e+",   "--1", "+-1", "-+1",   "1 ",
          " 1", "1,5", "1_000", "1:30", "0x10", "0o17", "0b1", "1.2.3", "1m",  "one", "1e5.5", "٣"}) {
        EXPECT_EQ(code_of(text), "wrong-type") << text;
    }
    for (const char* text : {"010", "-007", "00", "00.5", "1e999", "-1e999"}) {
        EXPECT_EQ(code_of(text), "bad-value") << text;
    }
    for (const char* text : {".inf", "-.inf", "+.INF", ".nan", ".NaN", "inf", "nan", "-Infinity"}) {
        EXPECT_EQ(code_of(text), "bad-value") << text;
    }
}

TEST(ParseNumber, NamesTheRangeAndTheText) {
    const Range lengths{0.0, 10.0, true, "m"};
    const Range seconds{0.0, 2.5, false, "s"};
    EXPECT_THAT(parse_number("0", lengths).message, ContainsRegex("more than 0 .*10 m.*'0'"));
    EXPECT_THAT(parse_number("-0.5", seconds).message, ContainsRegex("from 0 .*2\\.5 s.*'-0\\.5'"));
    EXPECT_THAT(parse_number("3", seconds).message, ContainsRegex("from 0 .*2\\.5 s.*'3'"));
    EXPECT_THAT(parse_number("tall", lengths).message, HasSubstr("'tall'"));
    EXPECT_THAT(parse_number("08", lengths).message, HasSubstr("'08'"));
    EXPECT_THAT(parse_number(".inf", lengths).message, HasSubstr("'.inf'"));
    EXPECT_EQ(parse_number("0", seconds).code.text(), "");
    EXPECT_EQ(parse_number("10", lengths).code.text(), "");
    EXPECT_EQ(parse_number("2.5", seconds).code.text(), "");
}

TEST(ParseNumber, RoundsLikeStrtod) {
    Dice dice(7);
    const auto digits = [&](int most) {
        std::string text;
        for (int i = 1 + dice.below(most); i > 0; --i) {
            text += static_cast<char>('0' + dice.below(10));
        }
        return text;
    };
    for (int i = 0; i < support::repeats(100'000); ++i) {
        std::string text = dice.chance(0.5) ? "-" : "";
        text += static_cast<char>('1' + dice.below(9)) + digits(22) + "." + digits(22);
        if (dice.chance(0.5)) {
            text += "e" + std::to_string(dice.below(560) - 290);
        }
        const ParsedNumber parsed = parse_number(text, kAny);
        ASSERT_EQ(parsed.code.text(), "") << text;
        ASSERT_EQ(parsed.value, std::strtod(text.c_str(), nullptr)) << text;
    }
}

TEST(ParseNumber, AcceptsDecimalNumbersAndNothingElse) {
    constexpr std::string_view kCharacters = "0123456789.+-eExn_ ";
    Dice dice(11);
    int accepted = 0;
    for (int i = 0; i < support::repeats(100'000); ++i) {
        std::string text;
        for (int length = dice.below(7); length > 0; --length) {
            text += kCharacters[static_cast<std::size_t>(dice.below(static_cast<int>(kCharacters.size())))];
        }
        const double value = std::strtod(text.c_str(), nullptr);
        const bool underflow = std::abs(value) < 1e-300 && text.find_first_of("eE") != std::string::npos;
        const bool fits = std::isfinite(value) && !underflow;
        const ParsedNumber parsed = parse_number(text, kAny);
        if (!is_decimal(text)) {
            ASSERT_NE(parsed.code.text(), "") << '\'' << text << '\'';
        } else if (fits) {
            ASSERT_EQ(parsed.code.text(), "") << '\'' << text << '\'';
            ASSERT_EQ(parsed.value, value) << text;
            ++accepted;
        }
    }
    EXPECT_GT(accepted, 1000 / (support::kSanitized ? 10 : 1));
}

}  // namespace
}  // namespace campuswalk::config
