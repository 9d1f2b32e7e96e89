#pragma once

#include "scene/import/source/model_source.h"

struct aiNode;

namespace campuswalk::scene {

/// Walks the hierarchy in document order, parents first. Local matrices are float32 in assimp; they are
/// multiplied in double. `X_world_file` goes in front of the root's.
NodeTree convert_nodes(const aiNode& root, const Eigen::Matrix4d& X_world_file);

}  // namespace campuswalk::scene
