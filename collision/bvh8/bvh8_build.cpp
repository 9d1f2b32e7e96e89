#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "collision/base/large_pages.h"
#include "collision/bvh8/bvh8.h"
#include "collision/bvh8/bvh8_fit.h"
#include "collision/bvh8/bvh8_leaf.h"
#include "collision/bvh8/bvh8_split.h"

namespace campuswalk::collision {

namespace {

/// The expected number of triangles of a node whose children are all leaves.
constexpr std::size_t kLowestNode = 88;

/// Divides triangles into nodes and leaves from the top down, then fills leaves and fits nodes from the
/// bottom up.
class Builder {
public:
    Builder(const TriangleMesh& mesh, Bvh8& tree) : mesh_(mesh), tree_(tree), leaf_maker_(mesh) {}

    void build() {
        fill_points();
        fill_items();
        find_middle();
        spare_.resize(items_.size());
        vertices_.reserve(items_.size());
        leaves_.reserve(items_.size() / 8);
        divide(make_part(items_));
        move_nodes();
        fill_leaves();
        fit_nodes();
        tree_.outer = sphere_about(middle_, vertices_);
    }

private:
    struct Part {
        std::span<SplitItem> items;
        std::optional<std::uint32_t> leaf;  ///< which holds the items, if they fit one
    };
    using Parts = std::array<Part, kBvh8Children>;

    void fill_points() {
        points_.reserve(mesh_.positions.size());
        for (const Eigen::Vector3f& p : mesh_.positions) {
            points_.push_back(lanes(p));
        }
        Lanes reach = Lanes::Zero();
        for (const Lanes& p : points_) {
            reach = reach.max(p.abs());
        }
        tree_.reach = reach.maxCoeff();
    }

    void fill_items() {
        items_.reserve(mesh_.triangles.size());
        for (const auto& [a, b, c] : mesh_.triangles) {
            const LaneBounds bounds{points_[a].min(points_[b]).min(points_[c]),
                                    points_[a].max(points_[b]).max(points_[c])};
            items_.emplace_back(bounds, static_cast<std::uint32_t>(items_.size()));
        }
    }

    void find_middle() {
        Vec3 sum = Vec3::Zero();
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            sum += incentre(vertices(mesh_, t));
        }
        middle_ = sum / static_cast<double>(mesh_.triangles.size());
    }

    /// The greatest number of triangles of a child for which the nodes below are full: one eighth of the
    /// smallest full tree for `items`.
    static std::size_t capacity_of_child(std::size_t items) {
        if (items <= kLowestNode) {
            return 1;
        }
        std::size_t capacity = kLowestNode;
        while (capacity * kBvh8Children < items) {
            capacity *= kBvh8Children;
        }
        return capacity;
    }

    /// Puts triangles that fit a leaf into one immediately, so that the leaves below any child are
    /// contiguous.
    Part make_part(std::span<SplitItem> items) {
        if (!leaf_maker_.make(items, leaves_.emplace_back())) {
            leaves_.pop_back();
            return {items, std::nullopt};
        }
        for (const std::uint32_t v : leaf_maker_.vertices()) {
            vertices_.push_back(points_[v]);
        }
        return {items, static_cast<std::uint32_t>(leaves_.size() - 1)};
    }

    /// The children of a node: the fullest is split until all fit or there are eight.
    std::size_t divide(const Part& whole, Parts& parts) {
        const std::size_t capacity = capacity_of_child(whole.items.size());
        parts[0] = whole;
        std::size_t count = 1;
        while (count < kBvh8Children) {
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
            const std::size_t left = split(items, spare_, simd_target_);
            parts[fullest] = make_part(items.first(left));
            parts[count++] = make_part(items.subspan(left));
        }
        return count;
    }

    /// Builds a node and, after it, those below it. The recursion is as deep as the tree, whose splits are
    /// never lopsided.
    std::uint32_t divide(const Part& whole) {
        Parts parts;
        const std::size_t count = divide(whole, parts);
        const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes.emplace_back().count = static_cast<std::uint8_t>(count);
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t child = parts[i].leaf ? *parts[i].leaf : divide(parts[i]);
            Bvh8Node& node = tree_.nodes[index];
            node.child[i] = child;
            node.leaves = static_cast<std::uint8_t>(node.leaves | (parts[i].leaf ? 1U << i : 0U));
        }
        return index;
    }

    template <typename Elements>
    static void reserve_exactly(Elements& elements, std::size_t count) {
        elements.reserve(count);
        prefer_large_pages(elements.data(), count * sizeof(typename Elements::value_type));
    }

    /// Into memory of exactly their size.
    void move_nodes() {
        std::vector<Bvh8Node> exact;
        reserve_exactly(exact, tree_.nodes.size());
        exact.assign(tree_.nodes.begin(), tree_.nodes.end());
        tree_.nodes = std::move(exact);
    }

    void fill_leaves() {
        reserve_exactly(tree_.leaves, leaves_.size());
        leaf_contents_.reserve(leaves_.size());
        std::size_t first = 0;
        for (const LeafTriangles& leaf : leaves_) {
            const std::span vertices = std::span<const Lanes>(vertices_).subspan(first, leaf.vertex_count);
            fill_leaf(tree_.leaves.emplace_back(), leaf, vertices);
            leaf_contents_.push_back(contents_of(vertices, middle_));
            first += vertices.size();
        }
    }

    void fit_nodes() {
        std::vector<Contents> node_contents(tree_.nodes.size());
        for (std::size_t n = tree_.nodes.size(); n-- > 0;) {
            Bvh8Node& node = tree_.nodes[n];
            std::array<Contents, kBvh8Children> contents;
            for (std::size_t i = 0; i < node.count; ++i) {
                const bool leaf = (node.leaves >> i & 1) != 0;
                contents[i] = (leaf ? leaf_contents_ : node_contents)[node.child[i]];
            }
            const std::span<const Contents> children(contents.data(), node.count);
            node_contents[n] = contents_of(children);
            fit_node(node, children, node_contents[n]);
        }
    }

    const TriangleMesh& mesh_;
    Bvh8& tree_;
    const SimdTarget simd_target_ = default_simd_target();
    std::vector<Lanes> points_;  ///< the mesh's positions
    std::vector<SplitItem> items_;
    std::vector<SplitItem> spare_;
    LeafMaker leaf_maker_;
    std::vector<LeafTriangles> leaves_;
    std::vector<Lanes> vertices_;  ///< of the leaves, one after the other
    std::vector<Contents> leaf_contents_;
    Vec3 middle_ = Vec3::Zero();  ///< mean of the incentres, the outer sphere's centre
};

}  // namespace

Bvh8 build_bvh8(const TriangleMesh& mesh) {
    Bvh8 tree;
    Builder(mesh, tree).build();
    return tree;
}

}  // namespace campuswalk::collision
