#include "scene/campus/building_bounds.h"

#include <Eigen/Geometry>

namespace campuswalk::scene {

namespace {

using collision::Detection;

Bounds bounds_of_nodes(const Campus& campus, const Building& building) {
    Bounds bounds;
    for (const NodeGlob& glob : building.nodes) {
        for (const Model& model : campus.models) {
            for (const std::size_t index : match_nodes(model, glob.pattern)) {
                const Node& node = model.nodes[index];
                for (const MeshIndex mesh : node.meshes) {
                    for (const Eigen::Vector3f& p : model.meshes[index_of(mesh)].positions) {
                        bounds.extend((node.X_world_node * p.cast<double>().homogeneous()).head<3>());
                    }
                }
            }
        }
    }
    return bounds;
}

}  // namespace

std::vector<Bounds> building_bounds(const Campus& campus) {
    std::vector<Bounds> all;
    for (const Building& building : campus.description.buildings) {
        all.push_back(bounds_of_nodes(campus, building));
    }
    for (const Detection detection : {Detection::solid | Detection::ray, Detection::trigger}) {
        std::vector<Bounds> of_colliders(all.size());
        for (std::size_t i = 0; i < campus.objects.size(); ++i) {
            const auto id = static_cast<collision::ObjectId>(i);
            const auto building = campus.objects[i].building;
            if (building && any_of(campus.world.object(id).detection, detection)) {
                const collision::Aabb& box = campus.world.bounds(id);
                of_colliders[*building].extend(Bounds{box.min, box.max});
            }
        }
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i] = all[i].empty() ? of_colliders[i] : all[i];
        }
    }
    return all;
}

}  // namespace campuswalk::scene
