#include "tests/scene/suggest/solid_model.h"

#include <utility>

#include "scene/model/world_triangles.h"

namespace campuswalk::scene::test {

std::shared_ptr<const collision::MeshCollider> solid(const Model& model) {
    collision::TriangleMesh mesh;
    for (const Node& node : model.nodes) {
        for_each_triangle(model, node, [&](const auto& a, const auto& b, const auto& c) {
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const Eigen::Vector3d& p : {a, b, c}) {
                mesh.positions.push_back(p.template cast<float>());
            }
            mesh.triangles.push_back({first, first + 1, first + 2});
        });
    }
    return std::make_shared<const collision::MeshCollider>(std::move(mesh));
}

}  // namespace campuswalk::scene::test
