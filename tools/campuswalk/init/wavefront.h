#pragma once

#include <span>
#include <string>

#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::tools::init {

struct NamedMesh {
    std::string name;
    collision::TriangleMesh mesh;
    Eigen::Vector3f color = Eigen::Vector3f::Constant(0.7F);  ///< red, green, blue in [0, 1]
};

/// The meshes as an OBJ file, an object each, in the material of its own name.
std::string wavefront(std::span<const NamedMesh> meshes, const std::string& material_file);
/// And these materials, as the MTL file.
std::string wavefront_materials(std::span<const NamedMesh> meshes);

}  // namespace campuswalk::tools::init
