#include "scene/model/common_ancestor.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

using Nodes = std::vector<std::size_t>;

Model model_with_parents(const std::vector<int>& parents) {
    Model model;
    for (const int parent : parents) {
        model.nodes.emplace_back();
        model.nodes.back().parent = parent;
    }
    return model;
}

/// From the node to its root.
Nodes path_from(const Model& model, std::size_t node) {
    Nodes path = {node};
    while (model.nodes[path.back()].parent >= 0) {
        path.push_back(static_cast<std::size_t>(model.nodes[path.back()].parent));
    }
    return path;
}

TEST(CommonAncestor, IsTheLowestNodeOnAllPathsToTheRoot) {
    std::mt19937 random(5);
    for (int trial = 0; trial < 500; ++trial) {
        std::vector<int> parents;
        for (int n = 0; n < 40; ++n) {
            parents.push_back(
                n == 0 || random() % 20 == 0 ? -1 : static_cast<int>(random() % static_cast<unsigned>(n)));
        }
        const Model model = model_with_parents(parents);
        Nodes nodes;
        for (std::size_t i = 0; i < 1 + random() % 4; ++i) {
            nodes.push_back(random() % parents.size());
        }
        Nodes common = path_from(model, nodes[0]);
        for (const std::size_t node : nodes) {
            const Nodes path = path_from(model, node);
            std::erase_if(common, [&](std::size_t n) { return std::ranges::find(path, n) == path.end(); });
        }
        EXPECT_EQ(common_ancestor(model, nodes),
                  common.empty() ? std::nullopt : std::optional(common.front()));
    }
}

}  // namespace
}  // namespace campuswalk::scene
