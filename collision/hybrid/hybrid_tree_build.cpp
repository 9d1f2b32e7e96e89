#include <numeric>
#include <span>

#include "collision/hybrid/hybrid_tree.h"
#include "collision/hybrid/hybrid_tree_split.h"

namespace campuswalk::collision {

namespace {

class Builder {
public:
    Builder(const TriangleMesh& mesh, const HybridTreeSettings& settings, HybridTree& tree)
        : mesh_(mesh), settings_(settings), tree_(tree) {}

    void build() {
        tree_.order.resize(mesh_.triangles.size());
        std::iota(tree_.order.begin(), tree_.order.end(), 0U);
        tree_.nodes.emplace_back();
        pending_.push_back({0, 0, static_cast<std::uint32_t>(tree_.order.size())});
        while (!pending_.empty()) {
            const Range range = pending_.back();
            pending_.pop_back();
            build_node(range);
        }
    }

private:
    struct Range {
        std::uint32_t node = 0;
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
    };

    void build_node(const Range& range) {
        const std::span<std::uint32_t> triangles(tree_.order.data() + range.begin, range.end - range.begin);
        HybridNode& node = tree_.nodes[range.node];
        node.outer = fit_outer_sphere(mesh_, triangles);
        node.inner = fit_inner_box(mesh_, triangles);
        if (triangles.size() <= settings_.leaf_triangles) {
            node.first = range.begin;
            node.count = static_cast<std::uint32_t>(triangles.size());
            return;
        }
        const auto middle = range.begin + static_cast<std::uint32_t>(split(mesh_, triangles, node.inner));
        const auto left = static_cast<std::uint32_t>(tree_.nodes.size());
        node.first = left;
        tree_.nodes.resize(tree_.nodes.size() + 2);  // `node` dangles from here on
        pending_.push_back({left + 1, middle, range.end});
        pending_.push_back({left, range.begin, middle});
    }

    const TriangleMesh& mesh_;
    const HybridTreeSettings& settings_;
    HybridTree& tree_;
    std::vector<Range> pending_;
};

}  // namespace

HybridTree build_hybrid_tree(const TriangleMesh& mesh, const HybridTreeSettings& settings) {
    HybridTree tree;
    if (!mesh.triangles.empty()) {
        Builder(mesh, settings, tree).build();
    }
    return tree;
}

}  // namespace campuswalk::collision
