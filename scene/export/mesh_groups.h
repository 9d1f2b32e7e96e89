#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "scene/model/model.h"

namespace campuswalk::scene {

/// What a file's nodes are tagged with: any numbers, ascending, such as the objects that a node belongs to.
using Tags = std::vector<std::uint32_t>;

/// A vertex without padding: vertices are equal if their bytes are.
struct ExportVertex {
    std::array<float, 3> position = {0, 0, 0};                 ///< metres from the group's origin
    std::array<std::int8_t, 4> normal = {};                    ///< signed normalized; the last is 0
    std::array<float, 2> uv = {0, 0};                          ///< v points down
    std::array<std::uint8_t, 4> color = {255, 255, 255, 255};  ///< linear
};
static_assert(sizeof(ExportVertex) == 28);

/// Triangles of one material, one set of tags and one square of the ground: drawn with one call.
struct MeshGroup {
    std::size_t material = 0;  ///< as `material_of` numbers them
    Tags tags;
    std::string node;  ///< the name of the node that all of it comes from; empty if there are several
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< world; a multiple of the step
    bool is_flat = false;  ///< every face is lit as a plane: normals are zero, and readers compute them
    bool has_uvs = false;
    bool has_colors = false;  ///< that differ from white
    std::vector<ExportVertex> vertices;
    std::vector<std::uint32_t> indices;
};

struct GroupSettings {
    double cell = 64.0;  ///< metres, edge of the squares
    /// Metres: vertices are moved to multiples of it, in the world, those that groups share to the same ones.
    /// 0: they stay where they are.
    double step = 0.0;
    std::function<std::size_t(std::size_t model, MaterialIndex material)> material_of;
    std::function<Tags(std::size_t model, std::size_t node)> tags_of;
};

/// All triangles of the models, each once per node that places it, in the order of material, tags and square.
/// Triangles that rounding leaves without area are left out.
std::vector<MeshGroup> group_triangles(std::span<const Model> models, const GroupSettings& settings);

}  // namespace campuswalk::scene
