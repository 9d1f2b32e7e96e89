#include "engine/report/plain_text.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace campuswalk::engine {
namespace {

const std::string kReplacement = "\xEF\xBF\xBD";

TEST(PlainText, LeavesReadableTextUnchanged) {
    const std::string text = "Überbau – 図書館 \U0001F6B6 \"quoted\" \\ & <b>";
    EXPECT_EQ(printable(text), text);
    EXPECT_EQ(xml_characters(text), text);
    EXPECT_EQ(valid_utf8(text), text);
}

TEST(PlainText, ReplacesEveryByteThatIsNotUtf8) {
    EXPECT_EQ(valid_utf8("caf\xe9!"), "caf" + kReplacement + "!");
    EXPECT_EQ(valid_utf8("\xc0\xaf"), kReplacement + kReplacement);  // '/' in too many bytes: overlong
    EXPECT_EQ(valid_utf8("\xed\xa0\x80"), kReplacement + kReplacement + kReplacement);  // a UTF-16 surrogate
    EXPECT_EQ(valid_utf8("\xf4\x90\x80\x80"),
              kReplacement + kReplacement + kReplacement + kReplacement);  // beyond the last code point
    EXPECT_EQ(valid_utf8("\xe2\x82"), kReplacement + kReplacement);        // truncated
    EXPECT_EQ(valid_utf8("\xef\xbf\xbf\xf4\x8f\xbf\xbf"), "\xef\xbf\xbf\xf4\x8f\xbf\xbf");
    EXPECT_EQ(valid_utf8(std::string(1, '\0')), std::string(1, '\0'));
}

TEST(PlainText, EscapesLineEndsAndControlCharacters) {
    EXPECT_EQ(printable("a\nb\r\t\x1b[31m\x7f\xc2\x9b\u2028" + std::string(1, '\0')),
              "a\\nb\\x0d\\x09\\x1b[31m\\x7f\\x9b\\u2028\\x00");
}

TEST(PlainText, EscapesWhatReordersText) {
    EXPECT_EQ(printable("a\u202eb\u2066c\u061cd\ufeff\U000E0041"),
              "a\\u202eb\\u2066c\\u061cd\\ufeff\\udb40\\udc41");
    EXPECT_EQ(printable("שלום مرحبا \U0001F469\u200D\U0001F680"), "שלום مرحبا \U0001F469\u200D\U0001F680");
}

TEST(PlainText, KeepsTheValuesOfJson) {
    const std::string name = "a\x1b\u009b\u202e##[x]##vso[y]\U000E0041\n\"";
    const std::string json = nlohmann::json({{"name", name}}).dump(2);
    const std::string safe = printable_json(json);
    EXPECT_EQ(nlohmann::json::parse(safe)["name"], name);
    EXPECT_EQ(safe.find_first_of("\x1b\xc2\xe2\xf3"), std::string::npos) << safe;
    EXPECT_EQ(safe.find("##"), std::string::npos) << safe;
    EXPECT_EQ(std::ranges::count(safe, '\n'), 2) << "its layout";
}

TEST(PlainText, LeavesNoCommandToCiMachines) {
    EXPECT_EQ(without_ci_commands("::error::x"), "\\x3a:error::x");
    EXPECT_EQ(without_ci_commands(" \t::error::x"), " \t\\x3a:error::x");
    EXPECT_EQ(without_ci_commands("##[x]##[y]"), "\\x23#[x]\\x23#[y]");
    EXPECT_EQ(without_ci_commands("a ##vso[x]"), "a \\x23#vso[x]");
    EXPECT_EQ(without_ci_commands("# walk-log 1 a::b ##"), "# walk-log 1 a::b ##");
    EXPECT_EQ(without_ci_commands("## a"), "\\x23# a");
    EXPECT_EQ(without_ci_commands("   "), "   ");
    for (const char* space : {"\u00a0", "\u1680", "\u2003", "\u202f", "\u205f", "\u3000"}) {
        EXPECT_EQ(without_ci_commands(space + std::string("::x")), space + std::string("\\x3a:x"));
    }
}

TEST(PlainText, EscapesEachLineOfAMessageToGitHub) {
    EXPECT_EQ(github_escaped("a%\n::b\x1b,\n", true), "a%25%0A\\x3a%3Ab\\x1b%2C%0A");
    EXPECT_EQ(github_escaped(std::string(1'000'000, '\n'), false).size(), 3'000'000U)
        << "one call for each overflows";
}

TEST(PlainText, ReplacesCharactersThatXmlForbids) {
    EXPECT_EQ(xml_characters("a\tb\n\x01\x0b\x1f" + std::string(1, '\0') + "\xef\xbf\xbe"),
              "a\tb\n" + kReplacement + kReplacement + kReplacement + kReplacement + kReplacement);
}

}  // namespace
}  // namespace campuswalk::engine
