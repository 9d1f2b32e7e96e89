#include "engine/render/geometry/building_bounds.h"

#include <Eigen/Geometry>

namespace campuswalk::engine::render {

std::vector<scene::Bounds> building_bounds(const scene::Campus& campus) {
    std::vector<scene::Bounds> all;
    for (const scene::Building& building : campus.description.buildings) {
        scene::Bounds bounds;
        for (const scene::NodeGlob& glob : building.nodes) {
            for (const scene::Model& model : campus.models) {
                for (const std::size_t index : scene::match_nodes(model, glob.pattern)) {
                    const scene::Node& node = model.nodes[index];
                    for (const scene::MeshIndex mesh : node.meshes) {
                        for (const Eigen::Vector3f& p : model.meshes[index_of(mesh)].positions) {
                            bounds.extend((node.X_world_node * p.cast<double>().homogeneous()).head<3>());
                        }
                    }
                }
            }
        }
        all.push_back(bounds);
    }
    return all;
}

}  // namespace campuswalk::engine::render
