#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "engine/render/geometry/campus_geometry.h"
#include "scene/model/model.h"

namespace campuswalk::engine::render {

/// Which meshes of the model are kept once however often they are placed: those that would take much memory.
/// For others baking all placements draws faster, as they join what is near them in one call.
std::vector<bool> meshes_to_share(const scene::Model& model);

/// Instances that are culled together.
struct InstanceGroup {
    std::size_t first = 0;  ///< index into InstancedMesh::instances
    std::size_t count = 0;
    Eigen::AlignedBox3d bounds;  ///< metres from CampusGeometry::origin
};

/// A mesh whose vertices are kept where its first placement has them, and its placements.
class InstancedMesh {
public:
    /// `X_campus_first` places the mesh first, at this node. It must have an inverse, or nothing is added.
    InstancedMesh(const Eigen::Matrix4d& X_campus_first, std::uint32_t node);

    /// False for a placement that isn't the first one turned, moved and scaled alike in every direction: its
    /// normals would need more than that.
    bool add(const Eigen::Matrix4d& X_campus_mesh, std::uint32_t node);

    /// Sorts the instances by the cells of `cell_size` metres that they are in, those of one in the order in
    /// which they were added. `first` bounds the first.
    std::vector<InstanceGroup> group(const Eigen::AlignedBox3d& first, double cell_size);

    const std::vector<Instance>& instances() const { return instances_; }

private:
    std::optional<Eigen::Matrix4d> X_mesh_campus_;  // of the first placement; none: it has no inverse
    std::vector<Instance> instances_;
};

}  // namespace campuswalk::engine::render
