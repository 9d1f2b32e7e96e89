#include "scene/campus/node_triangles.h"

#include <algorithm>
#include <variant>

#include "collision/mesh/mesh_collider.h"
#include "scene/campus/bake_mesh.h"
#include "scene/model/world_triangles.h"

namespace campuswalk::scene {

namespace {

/// The ends of the nodes' triangles in the mesh that was baked from them, about `p_world_origin`.
std::vector<std::uint32_t> ends_of(const Campus& campus, const std::vector<NodeRef>& nodes,
                                   const collision::Vec3& p_world_origin) {
    std::vector<std::uint32_t> ends;
    std::uint32_t count = 0;
    for (const NodeRef& ref : nodes) {
        const Model& model = campus.models[ref.model];
        for_each_triangle(model, model.nodes[ref.node], [&](const auto& a, const auto& b, const auto& c) {
            count += is_baked(a, b, c, p_world_origin) ? 1U : 0U;
        });
        ends.push_back(count);
    }
    return ends;
}

}  // namespace

NodeTriangles::NodeTriangles(const Campus& campus, const collision::Aabb& region)
    : ends_(campus.objects.size()) {
    for (std::size_t i = 0; i < campus.objects.size() && !campus.models.empty(); ++i) {
        const auto id = static_cast<collision::ObjectId>(i);
        const collision::Object& object = campus.world.object(id);
        const auto* mesh = std::get_if<std::shared_ptr<const collision::MeshCollider>>(&object.shape);
        if (mesh == nullptr || !campus.world.bounds(id).overlaps(region)) {
            continue;
        }
        const std::vector<NodeRef> nodes = nodes_of(campus.models, campus.objects[i].nodes);
        if (nodes.size() < 2) {
            continue;
        }
        std::vector<std::uint32_t> ends = ends_of(campus, nodes, object.X_world_shape.translation);
        if (ends.back() == (*mesh)->mesh().triangles.size()) {
            ends_[i] = std::move(ends);
        }
    }
}

std::optional<TriangleRange> NodeTriangles::of_same_node(collision::ObjectId object,
                                                         std::uint32_t triangle) const {
    const std::vector<std::uint32_t>& ends = ends_[index_of(object)];
    const auto end = std::ranges::upper_bound(ends, triangle);
    if (end == ends.end()) {
        return std::nullopt;
    }
    const TriangleRange range{end == ends.begin() ? 0 : *(end - 1), *end};
    return range.first == 0 && range.end == ends.back() ? std::nullopt : std::optional(range);
}

}  // namespace campuswalk::scene
