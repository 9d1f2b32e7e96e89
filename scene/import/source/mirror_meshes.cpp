#include "scene/import/source/mirror_meshes.h"

#include <optional>
#include <utility>

#include <Eigen/LU>

namespace campuswalk::scene {
namespace {

bool mirrors(const Node& node) {
    return node.X_world_node.topLeftCorner<3, 3>().determinant() < 0.0;
}

void flip_winding(Mesh& mesh) {
    for (auto& triangle : mesh.triangles) {
        std::swap(triangle[1], triangle[2]);
    }
}

}  // namespace

void mirror_meshes(Model& model) {
    std::vector<bool> used_upright(model.meshes.size(), false);
    for (const Node& node : model.nodes) {
        const bool upright = !mirrors(node);
        for (const MeshIndex mesh : node.meshes) {
            used_upright[index_of(mesh)] = used_upright[index_of(mesh)] || upright;
        }
    }
    std::vector<std::optional<MeshIndex>> flipped(model.meshes.size());
    for (Node& node : model.nodes) {
        if (!mirrors(node)) {
            continue;
        }
        for (MeshIndex& mesh : node.meshes) {
            auto& copy = flipped[index_of(mesh)];
            if (!copy) {
                copy = mesh;
                if (used_upright[index_of(mesh)]) {
                    copy = static_cast<MeshIndex>(model.meshes.size());
                    model.meshes.push_back(Mesh(model.meshes[index_of(mesh)]));
                }
                flip_winding(model.meshes[index_of(*copy)]);
            }
            mesh = *copy;
        }
    }
}

}  // namespace campuswalk::scene
