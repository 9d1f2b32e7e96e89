#include "collision/mesh/tree_level.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <variant>

#include "collision/bvh8/box_lanes.h"
#include "collision/bvh8/bvh8.h"
#include "collision/hybrid/hybrid_tree.h"

namespace campuswalk::collision {

namespace {

/// A node's box, and its index unless it is a leaf.
struct NodeBox {
    PosedBox posed;
    std::optional<std::uint32_t> inner;
};

NodeBox node_box(const HybridTree& tree, std::uint32_t index) {
    const HybridNode& node = tree.nodes[index];
    return {{{node.inner.half_extents}, {node.inner.axes, node.inner.center}},
            node.is_leaf() ? std::nullopt : std::optional(index)};
}

PosedBox posed_in(const BoxFrame& frame, const Vec3& center, const Vec3& half) {
    return {{half}, {frame.axes.transpose(), frame.origin + frame.axes.transpose() * center}};
}

NodeBox root_of(const HybridTree& tree) {
    return node_box(tree, 0);
}

NodeBox root_of(const Bvh8& tree) {
    const Bvh8Node& root = tree.nodes[0];
    const Vec3 low(root.low[0], root.low[1], root.low[2]);
    const Vec3 high(root.high[0], root.high[1], root.high[2]);
    return {posed_in(BoxFrame(root), 0.5 * (low + high), 0.5 * (high - low)), 0};
}

void add_children(const HybridTree& tree, std::uint32_t node, std::vector<NodeBox>& out) {
    const std::uint32_t left = tree.nodes[node].first;
    out.push_back(node_box(tree, left));
    out.push_back(node_box(tree, left + 1));
}

void add_children(const Bvh8& tree, std::uint32_t index, std::vector<NodeBox>& out) {
    const Bvh8Node& node = tree.nodes[index];
    const BoxFrame frame(node);
    for (std::size_t i = 0; i < node.count; ++i) {
        const bool leaf = (node.leaves >> i & 1) != 0;
        out.push_back({posed_in(frame, Vec3(node.center[0][i], node.center[1][i], node.center[2][i]),
                                Vec3(node.half[0][i], node.half[1][i], node.half[2][i])),
                       leaf ? std::nullopt : std::optional(node.child[i])});
    }
}

template <typename Tree>
std::vector<PosedBox> boxes_of(const Tree& tree, int level) {
    std::vector<NodeBox> current = {root_of(tree)};
    bool any_inner = true;
    for (int depth = 0; depth < level && any_inner; ++depth) {
        any_inner = false;
        std::vector<NodeBox> below;
        for (const NodeBox& each : current) {
            if (each.inner) {
                any_inner = true;
                add_children(tree, *each.inner, below);
            } else {
                below.push_back(each);
            }
        }
        current = std::move(below);
    }
    std::vector<PosedBox> boxes;
    boxes.reserve(current.size());
    for (const NodeBox& each : current) {
        boxes.push_back(each.posed);
    }
    return boxes;
}

}  // namespace

std::vector<PosedBox> boxes_at_level(const MeshCollider& mesh, int level) {
    return std::visit([&](const auto& tree) { return boxes_of(tree, level); }, mesh.tree());
}

}  // namespace campuswalk::collision
