#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "scene/import/source/model_source.h"

struct aiScene;

namespace campuswalk::scene {

/// The nodes in document order. Local matrices are float32 in assimp; they are multiplied in double. The
/// links that assimp makes of an FBX node's pivots and geometric transform become that one node again: what
/// its meshes are moved by (GeometricTranslation, -Rotation, -Scaling) doesn't move its children (Autodesk's
/// FBX SDK, "Computing transformation matrices").
NodeTree convert_nodes(const aiScene& scene, const Eigen::Matrix4d& X_world_file);

/// The FBX nodes that don't take their parents' scale as others do (InheritType 0, RrSs, or 2, Rrs) where
/// that makes a difference. assimp reads all as of type 1, RSrs.
std::vector<std::string> nodes_of_other_inheritance(const aiScene& scene);

}  // namespace campuswalk::scene
