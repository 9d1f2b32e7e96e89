#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "scene/model/model.h"

namespace campuswalk::engine::render {

/// A vertex as the shaders take it, 32 bytes.
struct Vertex {
    std::array<float, 3> position = {0, 0, 0};          ///< metres from CampusGeometry::origin
    std::array<std::int16_t, 4> normal = {0, 0, 0, 0};  ///< unit length is 32767
    std::array<float, 2> uv = {0, 0};
    std::array<std::uint8_t, 4> color = {255, 255, 255, 255};  ///< linear
};

Vertex make_vertex(const Eigen::Vector3d& position, const Eigen::Vector3d& normal, const Eigen::Vector2f& uv,
                   const std::array<std::uint8_t, 4>& color);

/// A material of any of the models, and the model, which owns its textures (null: it has none).
struct SurfaceMaterial {
    scene::Material material;
    const scene::Model* model = nullptr;
};

/// A place where triangles are drawn, beside the one that their vertices have.
struct Instance {
    /// From there, row by row: metres from CampusGeometry::origin to the same. As it stands, where they are.
    std::array<std::array<float, 4>, 3> rows = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    std::uint32_t node = 0;  ///< as in Placement; 0 for the vertices' own
};

Eigen::Affine3d placement_of(const Instance& instance);

/// Triangles of one material in one cell: what is culled and drawn in one call.
struct Batch {
    std::size_t material = 0;        ///< index into CampusGeometry::materials
    std::size_t first = 0;           ///< index into CampusGeometry::indices
    std::size_t count = 0;           ///< indices
    bool both_sides = false;         ///< drawn from behind too
    std::size_t first_instance = 0;  ///< index into CampusGeometry::instances
    std::size_t instances = 1;
    Eigen::AlignedBox3d bounds;  ///< of all instances, metres from CampusGeometry::origin
};

/// A see-through triangle, kept apart because such triangles are sorted for every image.
struct BlendTriangle {
    std::size_t material = 0;
    std::array<std::uint32_t, 3> corners = {0, 0, 0};
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
};

/// The vertices that one mesh has at one node: from `first_vertex` to the next one's.
struct Placement {
    std::size_t first_vertex = 0;  ///< index into CampusGeometry::vertices
    std::uint32_t node = 0;        ///< those of all models one after the other, from 1 on
};

/// Every mesh of every model placed in the world, ready for upload. Most placements are baked: a few hundred
/// thousand vertices are cheaper to keep than thousands of small draw calls. Of a mesh that is placed very
/// often the first placement is, and the others are instances of that (see instancing.h).
struct CampusGeometry {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< world point that vertex coordinates count from
    scene::Bounds bounds;                              ///< world
    std::vector<SurfaceMaterial> materials;
    std::vector<Vertex> vertices;
    std::vector<Placement> placements;   ///< in the vertices' order
    std::vector<std::uint32_t> indices;  ///< of the batches
    std::vector<Instance> instances;     ///< of the batches; the first is where vertices are
    std::vector<Batch> batches;          ///< opaque and masked, by material
    std::vector<BlendTriangle> blend;
};

/// `cell_size` in metres. `instancing` false bakes every placement. The models must outlive the result (it
/// points to them).
CampusGeometry bake(std::span<const scene::Model> models, double cell_size, bool instancing = true);

}  // namespace campuswalk::engine::render
