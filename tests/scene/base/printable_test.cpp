#include "scene/base/printable.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace campuswalk::scene {
namespace {

const std::string kReplacement = "\xEF\xBF\xBD";

TEST(Printable, LeavesReadableTextUnchanged) {
    for (const std::string text : {"Überbau – 図書館 \U0001F6B6 \"quoted\" \\ & <b>", "도서관", "शुभ पुस्तकालय",
                                   "ห้องสมุด", "ספרייה مكتبة ۷", "தமிழ்", "e\u0301 x\u0323", "C# a::b # ##",
                                   "## a", "[[1, 2], [3]] a|b", "# walk-log 1 a::b ##", "   ", "\u06dd7"}) {
        EXPECT_EQ(printable(text), text);
    }
}

TEST(Printable, ReplacesEveryByteThatIsNotUtf8) {
    EXPECT_EQ(printable("caf\xe9!"), "caf" + kReplacement + "!");
    EXPECT_EQ(printable("\xc0\xaf"), kReplacement + kReplacement);  // '/' in too many bytes: overlong
    EXPECT_EQ(printable("\xed\xa0\x80"), kReplacement + kReplacement + kReplacement);  // a UTF-16 surrogate
    EXPECT_EQ(printable("\xf4\x90\x80\x80"),
              kReplacement + kReplacement + kReplacement + kReplacement);  // beyond the last code point
    EXPECT_EQ(printable("\xe2\x82"), kReplacement + kReplacement);         // truncated
}

TEST(Printable, EscapesLineEndsAndControlCharacters) {
    EXPECT_EQ(printable("a\nb\r\t\x1b[31m\x7f\xc2\x9b\u2028" + std::string(1, '\0')),
              "a\\nb\\x0d\\x09\\x1b[31m\\x7f\\x9b\\u2028\\x00");
}

TEST(Printable, EscapesWhatReordersText) {
    EXPECT_EQ(printable("a\u202eb\u2066c\u061cd\ufeff\U000E0041"),
              "a\\u202eb\\u2066c\\u061cd\\ufeff\\udb40\\udc41");
}

TEST(Printable, EscapesWhatLooksLikeNothingOrLikeASpace) {
    for (const std::string bytes :
         {"\u00a0",     "\u00ad",     "\u034f",     "\u115f",     "\u1160",     "\u1680",     "\u17b4",
          "\u17b5",     "\u180b",     "\u180e",     "\u2000",     "\u2003",     "\u200a",     "\u200b",
          "\u200c",     "\u200d",     "\u202f",     "\u205f",     "\u2060",     "\u2061",     "\u2064",
          "\u2065",     "\u206a",     "\u2800",     "\u3000",     "\u3164",     "\ufe00",     "\ufe0f",
          "\ufeff",     "\uffa0",     "\ufff0",     "\ufff9",     "\ufffe",     "\uffff",     "\U0001bca0",
          "\U0001d173", "\U000e0000", "\U000e0020", "\U000e007f", "\U000e0100", "\U000e01ef", "\U000e0fff",
          "\U0001ffff"}) {
        const std::string shown = printable("a" + bytes + "b");
        EXPECT_EQ(shown.find(bytes), std::string::npos) << shown;
        EXPECT_TRUE(shown.starts_with("a\\")) << shown;
        EXPECT_EQ(printable(shown), shown) << "an escape stays as it is";
        EXPECT_EQ(nlohmann::json::parse(printable_json("\"" + bytes + "\"")), nlohmann::json(bytes));
    }
    EXPECT_EQ(printable("a\u200bb"), "a\\u200bb");
}

TEST(Printable, LeavesNoCommandToCiMachines) {
    EXPECT_EQ(printable("::error::x"), "\\x3a:error::x");
    EXPECT_EQ(printable("  ::error::x"), "  \\x3a:error::x");
    EXPECT_EQ(printable("##[x]##[y]"), "\\x23#[x]\\x23#[y]");
    EXPECT_EQ(printable("a ##vso[x]"), "a \\x23#vso[x]");
    EXPECT_EQ(printable("###VSO[x]"), "#\\x23#VSO[x]");
    EXPECT_EQ(printable("##teamcity[x]"), "\\x23#teamcity[x]");
    EXPECT_EQ(printable("##vso\u200b[x]"), "##vso\\u200b[x]");
    for (const char* space :
         {"\t", "\v", "\u0085", "\u00a0", "\u1680", "\u2003", "\u202f", "\u205f", "\u3000"}) {
        EXPECT_TRUE(printable(space + std::string("::x")).starts_with('\\')) << "GitHub trims it";
    }
}

TEST(Printable, LeavesNoMarkerToReadersOfReports) {
    EXPECT_EQ(printable("a [[ATTACHMENT|/etc/passwd]]"), "a \\x5b[ATTACHMENT|/etc/passwd]]");
    EXPECT_EQ(printable("[[[attachment|x]]"), "[\\x5b[attachment|x]]");
    EXPECT_EQ(printable("[[PROPERTY|a=b]][[|"), "\\x5b[PROPERTY|a=b]]\\x5b[|");
}

TEST(Printable, KeepsTheValuesOfJson) {
    const std::string name = "a\x1b\u009b\u202e##[x]##vso[y]\U000E0041\n\"[[ATTACHMENT|\u200b\u3164";
    const std::string json =
        nlohmann::json({{"name", name}, {"matrix", {{1, 2}, {3}}}, {"rows", {{"|", "a|"}}}}).dump(2);
    const std::string safe = printable_json(json);
    EXPECT_EQ(nlohmann::json::parse(safe), nlohmann::json::parse(json));
    EXPECT_TRUE(std::ranges::all_of(safe, [](char c) { return c == '\n' || (c >= ' ' && c < '\x7f'); }))
        << safe;
    EXPECT_EQ(safe.find("##"), std::string::npos) << safe;
    EXPECT_EQ(safe.find("[[ATT"), std::string::npos) << safe;
    EXPECT_EQ(std::ranges::count(safe, '\n'), std::ranges::count(json, '\n')) << "its layout";
    const std::string compact = nlohmann::json({{{"|", "a|"}}, {{1}}}).dump();
    EXPECT_EQ(printable_json(compact), compact);
}

}  // namespace
}  // namespace campuswalk::scene
