#pragma once

#include <vector>

#include "scene/model.h"

struct aiNode;

namespace campuswalk::scene {

/// Nodes with world transforms, not yet with meshes: `scene_meshes[i]` are node i's indices into the
/// aiScene's meshes.
struct NodeTree {
    std::vector<Node> nodes;
    std::vector<std::vector<unsigned int>> scene_meshes;
};

/// Walks the hierarchy in document order, parents first. Local matrices are float32 in assimp; they are
/// multiplied in double. `X_world_file` goes in front of the root's.
NodeTree convert_nodes(const aiNode& root, const Eigen::Matrix4d& X_world_file);

}  // namespace campuswalk::scene
