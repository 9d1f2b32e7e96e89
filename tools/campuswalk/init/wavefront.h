#pragma once

#include <span>
#include <string>

#include "collision/triangle_mesh.h"

namespace campuswalk::tools::init {

struct NamedMesh {
    std::string name;
    collision::TriangleMesh mesh;
};

/// The meshes as an OBJ file, an object each.
std::string wavefront(std::span<const NamedMesh> meshes);

}  // namespace campuswalk::tools::init
