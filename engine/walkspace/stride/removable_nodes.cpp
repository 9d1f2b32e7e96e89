#include "engine/walkspace/stride/removable_nodes.h"

#include <algorithm>
#include <memory>
#include <variant>

#include "collision/mesh/mesh_collider.h"

namespace campuswalk::engine {

namespace {

constexpr std::size_t kMostRemovable = 6;
/// So near to a body, metres.
constexpr double kBesideBody = 0.4;

bool is_same(const RemovableNode& a, const RemovableNode& b) {
    return a.object == b.object && a.triangles == b.triangles;
}

void keep_nearest(std::vector<RemovableNode>& nodes, const RemovableNode& node) {
    const auto known =
        std::ranges::find_if(nodes, [&](const RemovableNode& other) { return is_same(other, node); });
    if (known == nodes.end()) {
        nodes.push_back(node);
    } else if (node.distance < known->distance) {
        *known = node;
    }
}

/// The diagonal of its bounds.
double size_of(const collision::World& world, const RemovableNode& node) {
    const collision::Aabb bounds = bounds_of(world, node.object, node.triangles);
    return (bounds.max - bounds.min).norm();
}

}  // namespace

std::vector<RemovableNode> removable_nodes(const collision::World& world,
                                           const collision::QueryFilter& solids,
                                           const collision::MoverSettings& body,
                                           const scene::NodeTriangles& nodes,
                                           std::span<const GroundState> bodies, double largest) {
    std::vector<RemovableNode> found;
    std::vector<RemovableNode> grounds;
    std::vector<collision::Obstacle> near;
    for (const GroundState& at : bodies) {
        const collision::Segment core = body.core(at.foot);
        collision::gather_obstacles(world, solids, core, body.radius + kBesideBody, near);
        for (const collision::Obstacle& piece : near) {
            if (const auto triangles = nodes.of_same_node(piece.object, piece.triangle)) {
                const collision::Closest c = collision::closest(core, piece);
                keep_nearest(carries(at, c, body.radius) ? grounds : found,
                             {piece.object, *triangles, piece.triangle, c.distance, c.on_shape});
            }
        }
    }
    std::erase_if(found, [&](const RemovableNode& node) {
        return size_of(world, node) > largest ||
               std::ranges::any_of(grounds,
                                   [&](const RemovableNode& ground) { return is_same(node, ground); });
    });
    std::ranges::stable_sort(found, {}, &RemovableNode::distance);
    found.resize(std::min(found.size(), kMostRemovable));
    std::ranges::stable_sort(found, {}, [&](const RemovableNode& node) { return size_of(world, node); });
    return found;
}

collision::Aabb bounds_of(const collision::World& world, collision::ObjectId object,
                          const scene::TriangleRange& triangles) {
    const collision::Object& whole = world.object(object);
    const auto& mesh = std::get<std::shared_ptr<const collision::MeshCollider>>(whole.shape)->mesh();
    collision::Aabb bounds;
    for (std::uint32_t t = triangles.first; t < triangles.end; ++t) {
        const collision::Triangle triangle = collision::vertices(mesh, t);
        for (const collision::Vec3& vertex : {triangle.a, triangle.b, triangle.c}) {
            bounds.extend(whole.X_world_shape * vertex);
        }
    }
    return bounds;
}

bool carries(const GroundState& at, const collision::Closest& c, double radius) {
    constexpr double kTouching = 0.01;
    return c.distance <= radius + kTouching && c.on_shape.y() <= at.foot.y() + 0.3 * radius;
}

}  // namespace campuswalk::engine
