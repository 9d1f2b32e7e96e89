#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include "collision/wide_tree.h"
#include "collision/wide_tree_fit.h"
#include "collision/wide_tree_split.h"

namespace campuswalk::collision {

namespace {

/// Triangles that a node whose children are all leaves is expected to take.
constexpr std::size_t kLowestNode = 88;

class Builder {
public:
    Builder(const TriangleMesh& mesh, WideTree& tree) : mesh_(mesh), tree_(tree) {}

    void build() {
        items_.resize(mesh_.triangles.size());
        for (std::uint32_t t = 0; t < items_.size(); ++t) {
            items_[t].triangle = t;
            for (const std::uint32_t v : mesh_.triangles[t]) {
                const Eigen::Vector3f& p = mesh_.positions[v];
                items_[t].bounds.extend(Lanes(p.x(), p.y(), p.z(), 0.0F));
            }
        }
        tree_.nodes.reserve(items_.size() / 32 + 1);
        tree_.leaves.reserve(items_.size() / 8 + 1);
        build_node({items_, false});
        tree_.nodes.shrink_to_fit();
        tree_.leaves.shrink_to_fit();
    }

private:
    struct Part {
        std::span<SplitItem> items;
        bool leaf = false;
    };

    /// What a child may hold so that the nodes below come out full: one eighth of the least full tree that
    /// holds `items`.
    static std::size_t capacity_of_child(std::size_t items) {
        if (items <= kLowestNode) {
            return 1;
        }
        std::size_t capacity = kLowestNode;
        while (capacity * kWideChildren < items) {
            capacity *= kWideChildren;
        }
        return capacity;
    }

    /// The children of a node: the fullest is split until all fit or there are eight.
    std::size_t divide(const Part& whole, std::array<Part, kWideChildren>& parts) const {
        const std::size_t capacity = capacity_of_child(whole.items.size());
        parts[0] = {whole.items, fits_leaf(mesh_, whole.items)};
        std::size_t count = 1;
        while (count < kWideChildren) {
            std::size_t fullest = count;
            std::size_t most = capacity;
            for (std::size_t i = 0; i < count; ++i) {
                if (!parts[i].leaf && parts[i].items.size() > most) {
                    fullest = i;
                    most = parts[i].items.size();
                }
            }
            if (fullest == count) {
                break;
            }
            const std::span<SplitItem> items = parts[fullest].items;
            const std::size_t left = split_by_area(items);
            parts[fullest] = part(items.first(left));
            parts[count++] = part(items.subspan(left));
        }
        return count;
    }

    Part part(std::span<SplitItem> items) const { return {items, fits_leaf(mesh_, items)}; }

    /// Recursion is as deep as the tree, whose splits are never lopsided.
    std::uint32_t build_node(const Part& whole) {
        std::array<Part, kWideChildren> parts;
        const std::size_t count = divide(whole, parts);
        std::array<std::span<const SplitItem>, kWideChildren> children;
        WideNode node;
        for (std::size_t i = 0; i < count; ++i) {
            children[i] = parts[i].items;
            node.leaves = static_cast<std::uint8_t>(node.leaves | (parts[i].leaf ? 1U << i : 0U));
        }
        fit_node(node, mesh_, {children.data(), count});
        const std::size_t index = tree_.nodes.size();
        tree_.nodes.push_back(node);
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t child = parts[i].leaf ? build_leaf(parts[i]) : build_node(parts[i]);
            tree_.nodes[index].child[i] = child;
        }
        return static_cast<std::uint32_t>(index);
    }

    std::uint32_t build_leaf(const Part& part) {
        tree_.leaves.push_back(make_leaf(mesh_, part.items));
        return static_cast<std::uint32_t>(tree_.leaves.size() - 1);
    }

    const TriangleMesh& mesh_;
    WideTree& tree_;
    std::vector<SplitItem> items_;
};

}  // namespace

WideTree build_wide_tree(const TriangleMesh& mesh) {
    WideTree tree;
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    tree.outer = fit_outer_sphere(mesh, all);
    for (const Eigen::Vector3f& p : mesh.positions) {
        tree.reach = std::max(tree.reach, p.cwiseAbs().maxCoeff());
    }
    Builder(mesh, tree).build();
    return tree;
}

}  // namespace campuswalk::collision
