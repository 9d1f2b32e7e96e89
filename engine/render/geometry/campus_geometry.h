#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "scene/model/model.h"

namespace campuswalk::engine::render {

/// Vertex layout of the shaders, 32 bytes.
struct Vertex {
    std::array<float, 3> position = {0, 0, 0};          ///< metres from CampusGeometry::origin
    std::array<std::int16_t, 4> normal = {0, 0, 0, 0};  ///< signed normalized
    std::array<float, 2> uv = {0, 0};
    std::array<std::uint8_t, 4> color = {255, 255, 255, 255};  ///< linear
};

Vertex make_vertex(const Eigen::Vector3d& position, const Eigen::Vector3d& normal, const Eigen::Vector2f& uv,
                   const std::array<std::uint8_t, 4>& color);

/// A material and the model that owns its textures (null for the default material).
struct SurfaceMaterial {
    scene::Material material;
    const scene::Model* model = nullptr;
};

/// A transform that a mesh is drawn with, relative to its baked vertices.
struct Instance {
    /// Rows of an affine transform within the campus frame; identity by default.
    std::array<std::array<float, 4>, 3> rows = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    std::uint32_t node = 0;  ///< as in Placement; 0: the vertices' own
};

Eigen::Affine3d placement_of(const Instance& instance);

/// Triangles of one material in one cell: culled and drawn with one call.
struct Batch {
    std::size_t material = 0;        ///< index into CampusGeometry::materials
    std::size_t first = 0;           ///< index into CampusGeometry::indices
    std::size_t count = 0;           ///< indices
    bool double_sided = false;       ///< back faces are drawn too
    std::size_t first_instance = 0;  ///< index into CampusGeometry::instances
    std::size_t instances = 1;
    Eigen::AlignedBox3d bounds;  ///< of all instances, campus frame
};

/// A blended triangle, kept apart because these are sorted for every image.
struct BlendTriangle {
    std::size_t material = 0;
    std::array<std::uint32_t, 3> vertices = {0, 0, 0};
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
};

/// The vertices of one mesh at one node: from `first_vertex` to the next placement's.
struct Placement {
    std::size_t first_vertex = 0;  ///< index into CampusGeometry::vertices
    std::uint32_t node = 0;        ///< one-based, counted over all models
};

/// All meshes in the campus frame (the world frame moved to `origin`), ready for upload. Most placements are
/// baked, as a few hundred thousand vertices are cheaper than thousands of small draw calls. Meshes that are
/// placed very often are baked once and instanced (see instancing.h).
struct CampusGeometry {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< of the campus frame, in the world frame
    scene::Bounds bounds;                              ///< world frame
    std::vector<SurfaceMaterial> materials;
    std::vector<Vertex> vertices;
    std::vector<Placement> placements;   ///< in vertex order
    std::vector<std::uint32_t> indices;  ///< of the batches
    std::vector<Instance> instances;     ///< of the batches; the first is the identity
    std::vector<Batch> batches;          ///< opaque and masked, by material
    std::vector<BlendTriangle> blend;
};

/// `cell_size` in metres. Without `instancing` every placement is baked. The models must outlive the result.
CampusGeometry bake(std::span<const scene::Model> models, double cell_size, bool instancing = true);

}  // namespace campuswalk::engine::render
