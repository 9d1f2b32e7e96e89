#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "engine/render/geometry/campus_geometry.h"
#include "scene/model/model.h"

namespace campuswalk::engine::render {

/// Which meshes of the model are worth instancing: those whose placements would take much memory. Others draw
/// faster baked, as they are batched with their surroundings.
std::vector<bool> meshes_to_instance(const scene::Model& model);

/// Instances that are culled together.
struct InstanceGroup {
    std::size_t first = 0;  ///< index into InstancedMesh::instances
    std::size_t count = 0;
    Eigen::AlignedBox3d bounds;  ///< campus frame
};

/// A mesh baked at its first placement, and its placements relative to that.
class InstancedMesh {
public:
    /// `X_campus_first` is the placement at `node`. If it is singular, `add` rejects all others.
    InstancedMesh(const Eigen::Matrix4d& X_campus_first, std::uint32_t node);

    /// Returns false unless the placement is a similarity transform of the first one: others would need a
    /// separate matrix for normals.
    bool add(const Eigen::Matrix4d& X_campus_mesh, std::uint32_t node);

    /// Groups the instances by cells of `cell_size` metres, in order of addition within a cell. `first`
    /// bounds the first placement.
    std::vector<InstanceGroup> group(const Eigen::AlignedBox3d& first, double cell_size);

    const std::vector<Instance>& instances() const { return instances_; }

private:
    std::optional<Eigen::Matrix4d> X_mesh_campus_;  // inverse of the first placement; none if it is singular
    std::vector<Instance> instances_;
};

}  // namespace campuswalk::engine::render
