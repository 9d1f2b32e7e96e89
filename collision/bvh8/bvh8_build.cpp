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

/// Triangles that a node whose children are all leaves is expected to take.
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
        divide(part(items_));
        move_nodes();
        fill_leaves();
        fit_nodes();
        tree_.outer = sphere_about(middle_, vertices_);
    }

private:
    struct Part {
        std::span<SplitItem> items;
        std::optional<std::uint32_t> leaf;  ///< that they went into
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

    /// What a child may hold so that the nodes below come out full: one eighth of the least full tree that
    /// holds `items`.
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

    /// Triangles that fit a leaf are in one at once, so that the leaves below any child lie side by side.
    Part part(std::span<SplitItem> items) {
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
            parts[fullest] = part(items.first(left));
            parts[count++] = part(items.subspan(left));
        }
        return count;
    }

    /// A node and those below it, which come after it. Recursion is as deep as the tree, whose splits are
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

    /// Out of the memory that grew with them.
    void move_nodes() {
        std::vector<Bvh8Node> exact;
        reserve_exactly(exact, tree_.nodes.size());
        exact.assign(tree_.nodes.begin(), tree_.nodes.end());
        tree_.nodes = std::move(exact);
    }

    void fill_leaves() {
        reserve_exactly(tree_.leaves, leaves_.size());
        held_by_leaf_.reserve(leaves_.size());
        std::size_t first = 0;
        for (const LeafTriangles& leaf : leaves_) {
            const std::span vertices = std::span<const Lanes>(vertices_).subspan(first, leaf.vertices);
            fill_leaf(tree_.leaves.emplace_back(), leaf, vertices);
            held_by_leaf_.push_back(hold(vertices, middle_));
            first += vertices.size();
        }
    }

    void fit_nodes() {
        std::vector<Held> held_by_node(tree_.nodes.size());
        for (std::size_t n = tree_.nodes.size(); n-- > 0;) {
            Bvh8Node& node = tree_.nodes[n];
            std::array<Held, kBvh8Children> held;
            for (std::size_t i = 0; i < node.count; ++i) {
                const bool leaf = (node.leaves >> i & 1) != 0;
                held[i] = (leaf ? held_by_leaf_ : held_by_node)[node.child[i]];
            }
            const std::span<const Held> children(held.data(), node.count);
            held_by_node[n] = hold(children);
            fit_node(node, children, held_by_node[n]);
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
    std::vector<Held> held_by_leaf_;
    Vec3 middle_ = Vec3::Zero();  ///< mean of the incentres, the outer sphere's centre
};

}  // namespace

Bvh8 build_bvh8(const TriangleMesh& mesh) {
    Bvh8 tree;
    Builder(mesh, tree).build();
    return tree;
}

}  // namespace campuswalk::collision
