#include <algorithm>
#include <numeric>
#include <span>

#include "collision/hybrid_tree.h"

namespace campuswalk::collision {

namespace {

/// A split must leave at least one part in sixteen on each side, so that the depth stays logarithmic.
constexpr std::size_t kLopsided = 16;

class Builder {
public:
    Builder(const TriangleMesh& mesh, const HybridTreeSettings& settings, HybridTree& tree)
        : mesh_(mesh), settings_(settings), tree_(tree) {
        centres_.reserve(mesh.triangles.size());
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const Triangle t = corners(mesh, i);
            centres_.push_back((t.a + t.b + t.c) / 3.0);
        }
    }

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
        const auto middle = range.begin + static_cast<std::uint32_t>(split(triangles, node.inner));
        const auto left = static_cast<std::uint32_t>(tree_.nodes.size());
        node.first = left;
        tree_.nodes.resize(tree_.nodes.size() + 2);  // `node` dangles from here on
        pending_.push_back({left + 1, middle, range.end});
        pending_.push_back({left, range.begin, middle});
    }

    /// Reorders `triangles` and returns how many go to the left child; both sides get at least one.
    std::size_t split(std::span<std::uint32_t> triangles, const OrientedBox& box) const {
        int longest = 0;
        box.half_extents.maxCoeff(&longest);
        const Vec3 axis = box.axes.col(longest);
        const auto along = [&](std::uint32_t t) { return centres_[t].dot(axis); };

        double mean = 0.0;
        for (const std::uint32_t t : triangles) {
            mean += along(t);
        }
        mean /= static_cast<double>(triangles.size());
        const auto middle = std::stable_partition(triangles.begin(), triangles.end(),
                                                  [&](std::uint32_t t) { return along(t) < mean; });
        const auto left = static_cast<std::size_t>(middle - triangles.begin());
        const std::size_t least = std::max<std::size_t>(1, triangles.size() / kLopsided);
        if (left >= least && triangles.size() - left >= least) {
            return left;
        }
        const std::size_t half = triangles.size() / 2;
        std::nth_element(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(half),
                         triangles.end(), [&](std::uint32_t s, std::uint32_t t) {
                             const double x = along(s);
                             const double y = along(t);
                             return x != y ? x < y : s < t;
                         });
        return half;
    }

    const TriangleMesh& mesh_;
    const HybridTreeSettings& settings_;
    HybridTree& tree_;
    std::vector<Vec3> centres_;
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
