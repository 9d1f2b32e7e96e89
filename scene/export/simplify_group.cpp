#include "scene/export/simplify_group.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "collision/mesh/mesh_collider.h"
#include "collision/mesh/mesh_query.h"

namespace campuswalk::scene {

using Eigen::Vector3d;

namespace {

using Indices = std::vector<std::uint32_t>;

Vector3d position(const MeshGroup& group, std::uint32_t vertex) {
    const auto& p = group.vertices[vertex].position;
    return {p[0], p[1], p[2]};
}

std::optional<collision::MeshCollider> collider_of(const MeshGroup& group, const Indices& indices) {
    collision::TriangleMesh mesh;
    for (const ExportVertex& vertex : group.vertices) {
        mesh.positions.push_back({vertex.position[0], vertex.position[1], vertex.position[2]});
    }
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        mesh.triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
    }
    if (mesh.triangles.empty()) {
        return std::nullopt;
    }
    return std::optional<collision::MeshCollider>(std::in_place, std::move(mesh), collision::TreeKind::bvh8,
                                                  collision::Interior::unknown);
}

/// Whether the triangles' vertices, centres and edges' middles are no farther than `error` from the surface.
bool lies_within(const MeshGroup& group, const Indices& indices, const collision::MeshCollider& surface,
                 double error) {
    const auto near = [&](const Vector3d& point) {
        return collision::closest_point(surface, point).distance <= error;
    };
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const Vector3d a = position(group, indices[i]);
        const Vector3d b = position(group, indices[i + 1]);
        const Vector3d c = position(group, indices[i + 2]);
        if (!near((a + b + c) / 3.0) || !near(a) || !near(0.5 * (a + b)) || !near(0.5 * (b + c)) ||
            !near(0.5 * (c + a))) {
            return false;
        }
    }
    return true;
}

bool is_painted(const MeshGroup& group) {
    return std::ranges::any_of(group.vertices, [&](const ExportVertex& vertex) {
        return vertex.color != group.vertices.front().color;
    });
}

void replace_triangles(MeshGroup& group, Indices indices) {
    std::vector<ExportVertex> vertices(group.vertices.size());
    const std::size_t count =
        meshopt_optimizeVertexFetch(vertices.data(), indices.data(), indices.size(), group.vertices.data(),
                                    group.vertices.size(), sizeof(ExportVertex));
    vertices.resize(count);
    group.vertices = std::move(vertices);
    group.indices = std::move(indices);
}

}  // namespace

void simplify(MeshGroup& group, double error) {
    constexpr std::size_t kFewIndices = 48;  // nothing to gain
    constexpr double kWorthwhile = 0.9;      // of the triangles may remain
    constexpr int kAttempts = 3;
    if (group.indices.size() < kFewIndices || is_painted(group)) {
        return;
    }
    const float* positions = group.vertices.front().position.data();
    const float scale = meshopt_simplifyScale(positions, group.vertices.size(), sizeof(ExportVertex));
    std::optional<collision::MeshCollider> original;
    // The library bounds the mean distance, not the greatest: where that is too large, it is asked for less.
    double target = error;
    for (int attempt = 0; attempt < kAttempts; ++attempt, target *= 0.5) {
        Indices fewer(group.indices.size());
        fewer.resize(meshopt_simplify(fewer.data(), group.indices.data(), group.indices.size(), positions,
                                      group.vertices.size(), sizeof(ExportVertex), 0,
                                      static_cast<float>(target) / scale, meshopt_SimplifyLockBorder,
                                      nullptr));
        if (static_cast<double>(fewer.size()) > kWorthwhile * static_cast<double>(group.indices.size())) {
            return;
        }
        const std::optional<collision::MeshCollider> simple = collider_of(group, fewer);
        if (!simple || !lies_within(group, group.indices, *simple, error)) {
            continue;
        }
        original = original ? std::move(original) : collider_of(group, group.indices);
        if (lies_within(group, fewer, *original, error)) {
            replace_triangles(group, std::move(fewer));
            return;
        }
    }
}

}  // namespace campuswalk::scene
