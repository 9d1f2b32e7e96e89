#include "scene/model/model.h"

#include <cmath>

#include "scene/base/glob.h"
#include "scene/model/world_triangles.h"

namespace campuswalk::scene {

std::size_t count_triangles(const Model& model) {
    std::size_t count = 0;
    for (const Node& node : model.nodes) {
        for (const MeshIndex mesh : node.meshes) {
            count += model.meshes[index_of(mesh)].triangles.size();
        }
    }
    return count;
}

std::uint64_t count_bytes(const Model& model) {
    const auto bytes = [](const auto&... arrays) {
        return (std::uint64_t{0} + ... + (arrays.size() * sizeof(arrays[0])));
    };
    std::uint64_t count = 0;
    for (const Mesh& mesh : model.meshes) {
        count += bytes(mesh.positions, mesh.normals, mesh.uvs, mesh.colors, mesh.triangles);
    }
    for (const Texture& texture : model.textures) {
        count += bytes(texture.rgba);
    }
    for (const Node& node : model.nodes) {
        count += sizeof(Node) + bytes(node.name, node.meshes);
    }
    return count;
}

std::optional<std::size_t> find_node_beyond(const Model& model, double most) {
    std::vector<Bounds> bounds(model.meshes.size());
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        for (const Eigen::Vector3f& position : model.meshes[i].positions) {
            bounds[i].extend(position.cast<double>());
        }
    }
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const Eigen::Matrix3d axes = model.nodes[i].X_world_node.topLeftCorner<3, 3>();
        const Eigen::Vector3d origin = model.nodes[i].X_world_node.topRightCorner<3, 1>();
        for (const MeshIndex mesh : model.nodes[i].meshes) {
            const Bounds& own = bounds[index_of(mesh)];
            const Eigen::Vector3d half = 0.5 * (own.max - own.min);
            const Eigen::Vector3d reach = (axes * own.center() + origin).cwiseAbs() + axes.cwiseAbs() * half;
            if (!own.empty() && !(reach.array() <= most).all()) {
                return i;
            }
        }
    }
    return std::nullopt;
}

Bounds world_bounds(const Model& model) {
    Bounds bounds;
    for (const Node& node : model.nodes) {
        for_each_vertex(model, node, [&](const Eigen::Vector3d& p) { bounds.extend(p); });
    }
    return bounds;
}

Eigen::Vector3d origin_near(const Bounds& bounds) {
    constexpr double kRound = 1e3;  // metres
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    for (Eigen::Index axis = 0; axis < 3 && !bounds.empty(); ++axis) {
        const double center = 0.5 * (bounds.min[axis] + bounds.max[axis]);
        origin[axis] = std::abs(center) > kFarAway ? std::round(center / kRound) * kRound : 0.0;
    }
    return origin;
}

void move_origin(Model& model, const Eigen::Vector3d& origin) {
    for (Node& node : model.nodes) {
        node.X_world_node.topRightCorner<3, 1>() -= origin;
    }
    if (model.geographic) {
        model.geographic->at -= origin;
    }
}

std::vector<std::size_t> match_nodes(const Model& model, const std::string& glob) {
    std::vector<std::size_t> matched;
    std::vector<bool> inside(model.nodes.size(), false);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const Node& node = model.nodes[i];
        inside[i] = (node.parent >= 0 && inside[static_cast<std::size_t>(node.parent)]) ||
                    glob_matches(glob, node.name);
        if (inside[i]) {
            matched.push_back(i);
        }
    }
    return matched;
}

}  // namespace campuswalk::scene
