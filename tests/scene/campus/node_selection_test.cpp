#include "scene/campus/node_selection.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

std::vector<Model> model_of(const std::vector<std::string>& names) {
    Model model;
    for (const std::string& name : names) {
        Node node;
        node.name = name;
        model.nodes.push_back(node);
    }
    return {model};
}

NodeGlob glob_at(int line, const std::string& pattern) {
    return {{"demo.campus.yaml", line, 1}, pattern};
}

/// The lines of the errors of `act`: those it throws.
template <typename Act>
std::vector<std::string> lines_of(const Act& act) {
    std::vector<std::string> lines;
    try {
        act();
    } catch (const InputError& error) {
        for (const Diagnostic& each : error.diagnostics()) {
            lines.push_back(to_string(each));
        }
    }
    return lines;
}

TEST(NodeSelector, NamesTheGlobThatIsTooMuch) {
    const std::vector<Model> models = model_of({std::string(1000, 'a'), std::string(1000, 'b')});
    const std::vector<NodeGlob> globs = {glob_at(7, "b*"), glob_at(8, "*[" + std::string(1000, 'c') + "]")};
    constexpr std::uint64_t kMost = 1'000'000;
    const std::string expected =
        "demo.campus.yaml:8:1: error too-large: the globs up to this one take more than 1000000 comparisons "
        "with the names of nodes; use fewer or shorter ones";
    const auto checked = lines_of([&] {
        DiagnosticList diagnostics;
        NodeSelector(models, kMost).check(globs, diagnostics);
    });
    EXPECT_EQ(checked, std::vector<std::string>{expected});
    EXPECT_EQ(lines_of([&] { NodeSelector(models, kMost).select(globs, {}); }),
              std::vector<std::string>{expected});
}

TEST(NodeSelector, CountsAllCallsTogether) {
    const std::vector<Model> models = model_of({std::string(1000, 'a')});
    const std::vector<NodeGlob> globs = {glob_at(7, "*b")};
    NodeSelector selector(models, 2500);
    DiagnosticList diagnostics;
    selector.check(globs, diagnostics);
    selector.select(globs, {});
    EXPECT_EQ(lines_of([&] { selector.check(globs, diagnostics); }).size(), 1U);
}

TEST(NodeSelector, SuggestsNothingForWordsOfManyPages) {
    const std::vector<Model> models = model_of({std::string(100'000, 'a')});
    DiagnosticList diagnostics;
    NodeSelector(models).check(std::vector<NodeGlob>{glob_at(7, std::string(100'000, 'b'))}, diagnostics);
    ASSERT_EQ(diagnostics.all().size(), 1U);
    EXPECT_EQ(diagnostics.all()[0].code.text(), "no-node");
}

}  // namespace
}  // namespace campuswalk::scene
