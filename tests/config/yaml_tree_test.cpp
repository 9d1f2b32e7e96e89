#include "config/loader/yaml/yaml_tree.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/says.h"

namespace campuswalk::config {
namespace {

using scene::DiagnosticList;
using support::says;
using testing::ElementsAre;

std::vector<std::string> diagnostics_of(const std::string& text) {
    DiagnosticList diagnostics;
    const auto root = parse_yaml(text, "a.yaml", diagnostics);
    std::vector<std::string> lines;
    for (const scene::Diagnostic& diagnostic : diagnostics.all()) {
        lines.push_back(scene::to_string(diagnostic));
    }
    return lines;
}

/// The diagnostics of a text, one per line.
std::string about(const std::string& text) {
    std::string lines;
    for (const std::string& line : diagnostics_of(text)) {
        lines += line + "\n";
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

TEST(YamlTree, PlacesEmptyValuesAtTheirKeyOrDash) {
    const auto root = parsed("a:\nb:\n  -\n  - c\n");
    EXPECT_EQ(root->entries[0].value->kind, YamlNode::Kind::null);
    EXPECT_EQ(root->entries[0].value->line, 1);
    EXPECT_EQ(root->entries[1].value->items[0]->line, 3);
    EXPECT_EQ(root->entries[1].value->items[0]->column, 3);
}

TEST(YamlTree, PlacesEmptyListEntriesAtTheirDash) {
    const auto at = [](const std::string& text, std::size_t index) {
        const auto root = parsed(text);
        const YamlNode& item = *root->entries.at(0).value->items.at(index);
        EXPECT_EQ(item.kind, YamlNode::Kind::null);
        return std::to_string(item.line) + ":" + std::to_string(item.column);
    };
    EXPECT_EQ(at("a:\n  - b\n  -   # nothing\n\n  - c\n", 1), "3:3");
    EXPECT_EQ(at("a:\n  - b\n  -\n", 1), "3:3");
    EXPECT_EQ(at("a:\n  - b\n  -\nnames: c\n", 1), "3:3");
    EXPECT_EQ(at("a:\n  - b\n  - ~\n", 1), "3:5");
    EXPECT_EQ(at("a:\n  - b\n  - null # here\n", 1), "3:5");
}

TEST(YamlTree, CountsCharactersNotBytes) {
    EXPECT_EQ(parsed("{总图: é, x: 1}\n")->entries.at(1).column, 9);
    std::string line = "{a: '";
    for (int i = 0; i < 400; ++i) {
        line += "é";
    }
    EXPECT_EQ(parsed(line + "', b: 1}\n")->entries.at(1).column, 409);
}

TEST(YamlTree, SharesTheNodeThatAnAliasNames) {
    const auto root = parsed("a: &camera {view: top}\nb: *camera\n");
    EXPECT_EQ(root->entries[0].value, root->entries[1].value);
}

TEST(YamlTree, RefusesEmptyFiles) {
    for (const char* text : {"", "\n\n", "# only a comment\n", "---\n", "~\n"}) {
        EXPECT_THAT(about(text), says("a.yaml: error empty-file")) << text;
    }
}

TEST(YamlTree, ExplainsSyntaxErrors) {
    EXPECT_THAT(about("a:\n  b: 1\n c: 2\n"), says("a.yaml:3:2: error yaml-syntax", {"indentation"}));
    EXPECT_THAT(about("a: 1\n- b\n"), says("a.yaml:2:1: error yaml-syntax", {"indentation"}));
    EXPECT_THAT(about("a:\n  - b\n  c: 2\n"), says("a.yaml:3:3: error yaml-syntax", {"indentation"}));
    EXPECT_THAT(about("a: 1\nb: {c: 2\n"), says("a.yaml:2:4: error yaml-syntax", {"'{'", "'}'"}));
    EXPECT_THAT(about("a: [1, 2\nb: 3\n"), says("a.yaml:1:4: error yaml-syntax", {"'['", "']'"}));
    EXPECT_THAT(about("a: 1]\nb: [2]]\n"), says("a.yaml:2:7: error yaml-syntax"));
    EXPECT_THAT(about("title: Hall: West\n"), says("a.yaml:1:12: error yaml-syntax"));
    EXPECT_THAT(about("a: @b\n"), says("a.yaml:1:4: error yaml-syntax"));
    EXPECT_THAT(about("a: *b\n"), says("a.yaml:1:4: error yaml-syntax"));
    EXPECT_THAT(about("a: * b\n"), says("a.yaml:1:5: error yaml-syntax", {"'*'"}));
}

TEST(YamlTree, RefusesASecondDocument) {
    EXPECT_THAT(about("a: 1\n---\nb: 2\n"), says("a.yaml:2:1: error yaml-syntax", {"'---'"}));
}

TEST(YamlTree, RefusesUnclosedQuotes) {
    EXPECT_THAT(about("title: 'Main\nspawns: {}\n"), says("a.yaml:1:8: error yaml-syntax"));
    EXPECT_THAT(about("title: \"Main"), says("a.yaml:1:13: error yaml-syntax"));
    EXPECT_THAT(about("title: \"Main\n"), says("a.yaml:1:8: error yaml-syntax"));
}

TEST(YamlTree, DiagnosesEveryDuplicateKey) {
    EXPECT_THAT(diagnostics_of("a: 1\nb: {c: 1, c: 2}\na: 3\n"),
                ElementsAre(says("a.yaml:2:11: error duplicate-key", {"'c'", " line 2"}),
                            says("a.yaml:3:1: error duplicate-key", {"'a'", " line 1"})));
}

TEST(YamlTree, RefusesNonScalarKeysAndTags) {
    EXPECT_THAT(about("? [a]\n: b\n"), says("a.yaml:1:3: error wrong-type"));
    EXPECT_THAT(about("? {a: b}\n: b\n"), says("a.yaml:1:3: error wrong-type"));
    EXPECT_THAT(about("a: !!float 1\n"), says("a.yaml:1:4: error wrong-type"));
    EXPECT_THAT(about("a: !list [1]\n"), says("a.yaml:1:4: error wrong-type"));
}

TEST(YamlTree, RefusesAnAliasInsideItsAnchor) {
    EXPECT_THAT(about("a: &a [*a]\n"), says("a.yaml:1:8: error yaml-syntax", {"alias"}));
    EXPECT_THAT(about("a: &a {b: [1, {c: *a}]}\n"), says("a.yaml:1:19: error yaml-syntax", {"alias"}));
}

TEST(YamlTree, RefusesAliasBombs) {
    std::string text = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
    for (int i = 1; i < 12; ++i) {
        const std::string last = "*a" + std::to_string(i - 1);
        const std::string name = "a" + std::to_string(i);
        text.append(name).append(": &").append(name).append(" [");
        for (int j = 0; j < 10; ++j) {
            text += j == 0 ? "" : ", ";
            text += last;
        }
        text += "]\n";
    }
    EXPECT_THAT(about(text), says("a.yaml:6:5: error too-large"));
}

TEST(YamlTree, RefusesThousandsOfAnchors) {
    std::string text;
    for (int i = 0; i < 10'001; ++i) {
        text += "a" + std::to_string(i) + ": &b" + std::to_string(i) + " 1\n";
    }
    EXPECT_NE(about(text).find("error too-large: "), std::string::npos);
}

TEST(YamlTree, StopsReportingAfterTwoHundredMistakes) {
    std::string text;
    for (int i = 0; i < 100'000; ++i) {
        text += "a: 1\n";
    }
    const std::string lines = about(text);
    EXPECT_EQ(std::ranges::count(lines, '\n'), 201);
    EXPECT_TRUE(lines.find("\na.yaml: error too-many: ") != std::string::npos);
}

TEST(YamlTree, RefusesDeepNesting) {
    EXPECT_EQ(about("a: " + std::string(63, '[') + std::string(63, ']') + "\n"), "");
    EXPECT_THAT(about("a: " + std::string(64, '[') + std::string(64, ']') + "\n"),
                says("a.yaml:1:67: error too-large"));
    for (const char bracket : {'[', '{'}) {
        EXPECT_NE(about(std::string(100'000, bracket)).find("error too-large: "), std::string::npos);
    }
}

}  // namespace
}  // namespace campuswalk::config
