#include "config/loader/json/json_tree.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/says.h"

namespace campuswalk::config {
namespace {

using support::says;
using testing::ElementsAre;

std::vector<std::string> json_diagnostics(const std::string& text) {
    scene::DiagnosticList diagnostics;
    parse_json(text, "a.geojson", diagnostics);
    std::vector<std::string> lines;
    for (const scene::Diagnostic& diagnostic : diagnostics.all()) {
        lines.push_back(scene::to_string(diagnostic));
    }
    return lines;
}

std::shared_ptr<const YamlNode> tree_of(const std::string& text) {
    scene::DiagnosticList diagnostics;
    const auto root = parse_json(text, "a.geojson", diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << text;
    return root ? root : std::make_shared<YamlNode>();
}

TEST(JsonTree, KnowsWhereEverythingIs) {
    const auto root =
        tree_of("{\"b\":[1,-2.5e3 , true],\n\t\"ä\" : {\"c\":null}, \"d\": \"\\u00e4\\ud83d\\ude00\\/\"}");
    ASSERT_EQ(root->kind, YamlNode::Kind::map);
    ASSERT_EQ(root->entries.size(), 3U);
    const YamlNode& list = *root->entries[0].value;
    EXPECT_EQ(root->entries[0].key, "b");
    EXPECT_EQ(root->entries[0].column, 2);
    EXPECT_EQ(list.kind, YamlNode::Kind::sequence);
    EXPECT_EQ(list.column, 6);
    ASSERT_EQ(list.items.size(), 3U);
    EXPECT_EQ(list.items[0]->text, "1");
    EXPECT_EQ(list.items[0]->column, 7);
    EXPECT_FALSE(list.items[0]->quoted);
    EXPECT_EQ(list.items[1]->text, "-2.5e3");
    EXPECT_EQ(list.items[1]->column, 9);
    EXPECT_EQ(list.items[2]->text, "true");
    EXPECT_EQ(list.items[2]->column, 18);
    EXPECT_EQ(root->entries[1].key, "ä");
    EXPECT_EQ(root->entries[1].line, 2);
    EXPECT_EQ(root->entries[1].column, 2);
    EXPECT_EQ(root->entries[1].value->column, 8);  // characters, not bytes
    EXPECT_EQ(root->entries[1].value->entries[0].value->kind, YamlNode::Kind::null);
    EXPECT_EQ(root->entries[2].value->text, "ä😀/");
    EXPECT_TRUE(root->entries[2].value->quoted);
    EXPECT_EQ(root->entries[2].value->column, 25);
}

TEST(JsonTree, DiagnosesWhatIsNoJson) {
    EXPECT_THAT(json_diagnostics("{\"a\": [1, 2,]}"),
                ElementsAre(says("a.geojson:1:13: error json-syntax", {"unexpected ']'"})));
    EXPECT_THAT(json_diagnostics("{\n  a: 1}"), ElementsAre(says("a.geojson:2:3: error json-syntax")));
    EXPECT_THAT(json_diagnostics("{\"a\": 1e999}"),
                ElementsAre(says("a.geojson:1:12: error json-syntax", {"out of range"})));
    EXPECT_THAT(json_diagnostics(""), ElementsAre(says("a.geojson:1:1: error json-syntax")));
    EXPECT_THAT(json_diagnostics("{} {}"), ElementsAre(says("a.geojson:1:4: error json-syntax")));
    EXPECT_THAT(json_diagnostics("[\"\xff\"]"), ElementsAre(says("a.geojson:1:3: error json-syntax")));
    EXPECT_THAT(json_diagnostics("[\"a\nb\"]"), ElementsAre(says("a.geojson:1:4: error json-syntax")));
    EXPECT_THAT(json_diagnostics("// a comment\n1"), ElementsAre(says("a.geojson:1:1: error json-syntax")));
    EXPECT_THAT(json_diagnostics("{\"a\": 1, \"b\": {\"c\": 1,\n \"c\": 2}}"),
                ElementsAre(says("a.geojson:2:2: error duplicate-key", {"'c'", "line 1"})));
}

TEST(JsonTree, RefusesWhatIsTooLarge) {
    const std::string deep = std::string(65, '[') + std::string(65, ']');
    EXPECT_THAT(json_diagnostics(deep), ElementsAre(says("a.geojson:1:65: error too-large")));
    EXPECT_THAT(json_diagnostics(deep.substr(1, 128)), ElementsAre());
    EXPECT_THAT(json_diagnostics(std::string(5'000'000, '[')),
                ElementsAre(says("a.geojson:1:65: error too-large")));
    std::string wide = "[0";
    for (int i = 0; i < 1'000'000; ++i) {
        wide += ",0";
    }
    EXPECT_THAT(json_diagnostics(wide + "]"),
                ElementsAre(says("a.geojson:1:2000002: error too-large", {"a million"})));
}

TEST(JsonTree, RefusesEachBeginningOfAText) {
    const std::string text = R"({"type": "FeatureCollection", "n": [-1.5e-3, true, null, "\u00e4"]})";
    for (std::size_t length = 0; length < text.size(); ++length) {
        EXPECT_EQ(json_diagnostics(text.substr(0, length)).size(), 1U) << length;
    }
}

}  // namespace
}  // namespace campuswalk::config
