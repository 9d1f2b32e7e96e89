#include "config/loader/yaml_tree.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace campuswalk::config {
namespace {

using scene::DiagnosticList;

/// The diagnostics about a text, a line each.
std::string about(const std::string& text) {
    DiagnosticList diagnostics;
    const auto root = parse_yaml(text, "a.yaml", diagnostics);
    std::string lines;
    for (const scene::Diagnostic& diagnostic : diagnostics.all()) {
        lines += scene::to_string(diagnostic) + "\n";
    }
    return lines;
}

std::shared_ptr<const YamlNode> parsed(const std::string& text) {
    DiagnosticList diagnostics;
    const auto root = parse_yaml(text, "a.yaml", diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << text;
    return root ? root : std::make_shared<YamlNode>();
}

TEST(YamlTree, KeepsOrderAndPlaces) {
    const auto root = parsed("b: 1\na:\n  - x\n  - \"y z\"\n");
    ASSERT_EQ(root->kind, YamlNode::Kind::map);
    ASSERT_EQ(root->entries.size(), 2U);
    EXPECT_EQ(root->entries[0].key, "b");
    EXPECT_EQ(root->entries[0].line, 1);
    EXPECT_EQ(root->entries[0].value->text, "1");
    EXPECT_EQ(root->entries[0].value->column, 4);
    const YamlNode& list = *root->entries[1].value;
    ASSERT_EQ(list.kind, YamlNode::Kind::sequence);
    ASSERT_EQ(list.items.size(), 2U);
    EXPECT_EQ(list.items[1]->text, "y z");
    EXPECT_TRUE(list.items[1]->quoted);
    EXPECT_FALSE(list.items[0]->quoted);
    EXPECT_EQ(list.items[1]->line, 4);
    EXPECT_EQ(list.items[1]->column, 5);
}

TEST(YamlTree, PutsEmptyValuesWhereTheyAreMissed) {
    const auto root = parsed("a:\nb:\n  -\n  - c\n");
    EXPECT_EQ(root->entries[0].value->kind, YamlNode::Kind::null);
    EXPECT_EQ(root->entries[0].value->line, 1);
    EXPECT_EQ(root->entries[1].value->items[0]->line, 3);
    EXPECT_EQ(root->entries[1].value->items[0]->column, 3);
}

TEST(YamlTree, SharesWhatAliasesName) {
    const auto root = parsed("a: &camera {view: top}\nb: *camera\n");
    EXPECT_EQ(root->entries[0].value, root->entries[1].value);
}

TEST(YamlTree, RefusesEmptyFiles) {
    for (const char* text : {"", "\n\n", "# only a comment\n", "---\n", "~\n"}) {
        EXPECT_EQ(about(text),
                  "a.yaml: error empty-file: there is nothing in this file but comments or spaces\n")
            << text;
    }
}

TEST(YamlTree, ExplainsSyntaxErrors) {
    const std::string continues =
        "this line doesn't continue what is above: check its indentation, its '-' and its ':'\n";
    EXPECT_EQ(about("a:\n  b: 1\n c: 2\n"), "a.yaml:3:2: error yaml-syntax: " + continues);
    EXPECT_EQ(about("a: 1\n- b\n"), "a.yaml:2:1: error yaml-syntax: " + continues);
    EXPECT_EQ(about("a:\n  - b\n  c: 2\n"), "a.yaml:3:3: error yaml-syntax: " + continues);
    EXPECT_EQ(about("a: 1\nb: {c: 2\n"),
              "a.yaml:2:4: error yaml-syntax: this '{' has no '}', or a ',' is missing after it\n");
    EXPECT_EQ(about("a: [1, 2\nb: 3\n"),
              "a.yaml:1:4: error yaml-syntax: this '[' has no ']', or a ',' is missing after it\n");
    EXPECT_EQ(about("a: 1]\nb: [2]]\n"), "a.yaml:2:7: error yaml-syntax: this bracket closes nothing\n");
    EXPECT_EQ(
        about("title: Hall: West\n"),
        "a.yaml:1:12: error yaml-syntax: a second ': ' on this line; put a text with a colon in quotes\n");
    EXPECT_EQ(
        about("a: @b\n"),
        "a.yaml:1:4: error yaml-syntax: no value can start with this character; put the text in quotes\n");
    EXPECT_EQ(about("a: *b\n"),
              "a.yaml:1:4: error yaml-syntax: nothing has this name; put the text in quotes if no reference "
              "was meant\n");
    EXPECT_EQ(about("a: * b\n"),
              "a.yaml:1:5: error yaml-syntax: put the text in quotes: '*' starts a reference\n");
}

TEST(YamlTree, RefusesASecondDocument) {
    EXPECT_EQ(about("a: 1\n---\nb: 2\n"),
              "a.yaml:2:1: error yaml-syntax: text after the end of the document: a stray bracket, less "
              "indentation than above, or a second '---'\n");
}

TEST(YamlTree, RefusesQuotesThatNothingCloses) {
    EXPECT_EQ(about("title: 'Main\nspawns: {}\n"),
              "a.yaml:1:8: error yaml-syntax: this quote is never closed\n");
    EXPECT_EQ(about("title: \"Main"), "a.yaml:1:13: error yaml-syntax: a quote above is never closed\n");
    EXPECT_EQ(about("title: \"Main\n"), "a.yaml:1:8: error yaml-syntax: this quote is never closed\n");
}

TEST(YamlTree, DiagnosesEveryKeyThatIsGivenTwice) {
    EXPECT_EQ(
        about("a: 1\nb: {c: 1, c: 2}\na: 3\n"),
        "a.yaml:2:11: error duplicate-key: key 'c' was given on line 2 already; remove one of the two\n"
        "a.yaml:3:1: error duplicate-key: key 'a' was given on line 1 already; remove one of the two\n");
}

TEST(YamlTree, RefusesKeysThatAreNoWordsAndTags) {
    EXPECT_EQ(about("? [a]\n: b\n"),
              "a.yaml:1:3: error wrong-type: a key must be a word, as in 'title: Library'\n");
    EXPECT_EQ(about("? {a: b}\n: b\n"),
              "a.yaml:1:3: error wrong-type: a key must be a word, as in 'title: Library'\n");
    EXPECT_EQ(about("a: !!float 1\n"),
              "a.yaml:1:4: error wrong-type: tags are not used here; remove the word with the '!'\n");
    EXPECT_EQ(about("a: !list [1]\n"),
              "a.yaml:1:4: error wrong-type: tags are not used here; remove the word with the '!'\n");
}

TEST(YamlTree, RefusesAnAliasInsideWhatItNames) {
    const char* inside = "an alias inside what it names; write the value out\n";
    EXPECT_EQ(about("a: &a [*a]\n"), std::string("a.yaml:1:8: error yaml-syntax: ") + inside);
    EXPECT_EQ(about("a: &a {b: [1, {c: *a}]}\n"), std::string("a.yaml:1:19: error yaml-syntax: ") + inside);
}

TEST(YamlTree, RefusesAliasBombs) {
    std::string text = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
    for (int i = 1; i < 12; ++i) {
        const std::string last = "*a" + std::to_string(i - 1);
        const std::string name = "a" + std::to_string(i);
        text += name + ": &" + name + " [";
        for (int j = 0; j < 10; ++j) {
            text += (j == 0 ? "" : ", ") + last;
        }
        text += "]\n";
    }
    EXPECT_EQ(about(text),
              "a.yaml:6:5: error too-large: more than a million values (aliases count in full)\n");
}

TEST(YamlTree, RefusesAnchorsByTheThousand) {
    std::string text;
    for (int i = 0; i < 10'001; ++i) {
        text += "a" + std::to_string(i) + ": &b" + std::to_string(i) + " 1\n";
    }
    EXPECT_NE(about(text).find("error too-large: more than ten thousand names"), std::string::npos);
}

TEST(YamlTree, StopsComplainingAfterTwoHundredMistakes) {
    std::string text;
    for (int i = 0; i < 100'000; ++i) {
        text += "a: 1\n";
    }
    const std::string lines = about(text);
    EXPECT_EQ(std::ranges::count(lines, '\n'), 201);
    EXPECT_TRUE(
        lines.ends_with("a.yaml: error too-many: there are more mistakes than 200; these are the first\n"));
}

TEST(YamlTree, RefusesDeepNesting) {
    EXPECT_EQ(about("a: " + std::string(63, '[') + std::string(63, ']') + "\n"), "");
    EXPECT_EQ(about("a: " + std::string(64, '[') + std::string(64, ']') + "\n"),
              "a.yaml:1:67: error too-large: nested more than 64 deep\n");
    for (const char bracket : {'[', '{'}) {
        EXPECT_NE(about(std::string(100'000, bracket)).find("error too-large: nested more than 64 deep"),
                  std::string::npos);
    }
}

}  // namespace
}  // namespace campuswalk::config
