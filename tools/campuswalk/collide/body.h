#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "collision/geometry/shapes.h"
#include "scene/base/diagnostic.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::tools::collide {

/// One of the two that are held against each other.
struct Body {
    std::string name;  ///< as on the command line
    collision::Shape shape;
    /// Of a mesh, where its origin lies in the file's frame; it isn't turned there.
    collision::Vec3 p_body_mesh = collision::Vec3::Zero();

    /// A node's triangles are those from the end of the one before.
    struct Node {
        std::uint32_t end = 0;
        std::string name;
    };
    std::vector<Node> nodes;  ///< of a mesh, those that have triangles

    /// The collider of a mesh, or nullptr.
    const collision::MeshCollider* mesh() const;
    /// The name of the node that a mesh's triangle belongs to.
    const std::string& node_of(std::uint32_t triangle) const;
};

/// A shape (see parse_shape.h) or a model file, all meshes of all nodes together; triangles are numbered from
/// 0 in the order of the nodes. `frame` says how files are to be read. Throws scene::InputError; what a file
/// asks for and doesn't get goes to `warnings`.
Body read_body(const std::string& word, const scene::SceneFile& frame,
               std::vector<scene::Diagnostic>& warnings);

}  // namespace campuswalk::tools::collide
