#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "scene/import/source/sanitize_mesh.h"

namespace campuswalk::scene::gltf {

/// How a node deforms the mesh that it draws: by its morph targets first, then by the joints of its skin
/// (glTF 2.0, 3.7.2.2 and 3.7.3).
struct Deformation {
    std::vector<float> weights;  ///< by morph target; missing ones are 0
    std::vector<Eigen::Matrix4d>
        X_node_bound;  ///< by joint: the joint × its inverse bind matrix; empty without a skin
};

/// The displacements of one morph target; each empty or one per vertex.
struct MorphTarget {
    float weight = 0.0F;
    std::vector<Eigen::Vector3f> positions;
    std::vector<Eigen::Vector3f> normals;
};

/// The accessors, or the ids in a Draco mesh, of JOINTS_n and WEIGHTS_n.
struct JointSource {
    std::size_t joints;
    std::size_t weights;
};

/// JOINTS_n and WEIGHTS_n: four joints of each vertex.
struct JointSet {
    std::vector<Eigen::Vector4f> joints;
    std::vector<Eigen::Vector4f> weights;
};

/// Adds what the targets move each vertex by.
void apply_morph_targets(const std::vector<MorphTarget>& targets, RawMesh& mesh);

/// Moves each vertex by its joints. Weights needn't add up to 1; a vertex without any follows the first joint
/// that it names. Triangles that are mirrored keep their outside. False if a vertex names a joint that
/// doesn't exist.
[[nodiscard]] bool apply_skin(const std::vector<Eigen::Matrix4d>& X_node_bound,
                              const std::vector<JointSet>& sets, RawMesh& mesh);

}  // namespace campuswalk::scene::gltf
