#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "collision/geometry/shapes.h"
#include "scene/base/diagnostic.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::tools::collide {

/// One of the two bodies that are tested for overlap.
struct Body {
    std::string name;  ///< as on the command line
    collision::Shape shape;
    /// Of a mesh: its origin in the file's frame. The axes are the same.
    collision::Vec3 p_body_mesh = collision::Vec3::Zero();

    /// A node's triangles start where those of the node before it end.
    struct Node {
        std::uint32_t end = 0;
        std::string name;
    };
    std::vector<Node> nodes;  ///< of a mesh: those that have triangles

    /// The collider of a mesh, or nullptr.
    const collision::MeshCollider* mesh() const;
    /// The name of the node that a mesh's triangle belongs to.
    const std::string& node_of(std::uint32_t triangle) const;
};

/// Reads a shape (see parse_shape.h) or a model file with all meshes of all nodes; triangles are numbered
/// from 0 in the order of the nodes. `frame` says how to read files. Features of a file that the import
/// doesn't support go to `warnings`. Throws scene::InputError.
Body read_body(const std::string& argument, const scene::SceneFile& frame,
               std::vector<scene::Diagnostic>& warnings);

}  // namespace campuswalk::tools::collide
