#pragma once

#include <array>

#include <Eigen/Core>

#include "scene/model/model.h"

namespace campuswalk::scene {

/// Calls `visit(a, b, c)` with the world vertices of each triangle of the node's own meshes.
template <typename Visit>
void for_each_triangle(const Model& model, const Node& node, const Visit& visit) {
    const Eigen::Matrix3d linear = node.X_world_node.topLeftCorner<3, 3>();
    const Eigen::Vector3d offset = node.X_world_node.topRightCorner<3, 1>();
    for (const MeshIndex index : node.meshes) {
        const Mesh& mesh = model.meshes[index_of(index)];
        for (const std::array<std::uint32_t, 3>& t : mesh.triangles) {
            const Eigen::Vector3d a = linear * mesh.positions[t[0]].cast<double>() + offset;
            const Eigen::Vector3d b = linear * mesh.positions[t[1]].cast<double>() + offset;
            const Eigen::Vector3d c = linear * mesh.positions[t[2]].cast<double>() + offset;
            visit(a, b, c);
        }
    }
}

/// Calls `visit(p)` with the world position of each vertex of the node's own meshes.
template <typename Visit>
void for_each_vertex(const Model& model, const Node& node, const Visit& visit) {
    const Eigen::Matrix3d linear = node.X_world_node.topLeftCorner<3, 3>();
    const Eigen::Vector3d offset = node.X_world_node.topRightCorner<3, 1>();
    for (const MeshIndex index : node.meshes) {
        for (const Eigen::Vector3f& position : model.meshes[index_of(index)].positions) {
            const Eigen::Vector3d p = linear * position.cast<double>() + offset;
            visit(p);
        }
    }
}

}  // namespace campuswalk::scene
