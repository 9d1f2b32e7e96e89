#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "scene/import/gltf/accessors.h"
#include "scene/import/gltf/document.h"

namespace campuswalk::scene::gltf {

/// The joints of a skin (glTF 2.0, 3.7.3).
struct Skin {
    std::vector<std::size_t> joints;             ///< nodes of the file; at least one
    std::vector<Eigen::Matrix4d> X_joint_bound;  ///< by joint: its inverse bind matrix
};

/// Throws GltfError if the skin doesn't exist, has no joints, or fewer matrices than joints.
Skin read_skin(const Document& document, Accessors& accessors, std::size_t index);

}  // namespace campuswalk::scene::gltf
