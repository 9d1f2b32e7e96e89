#pragma once

#include "collision/mesh_collider.h"

namespace campuswalk::bench {

/// The wide layout beside the paper's: rays, avatars, closest points. Whether all answers are the same to the
/// last bit.
bool compare_layouts(const collision::MeshCollider& campus, int rounds);

}  // namespace campuswalk::bench
