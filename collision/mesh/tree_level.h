#pragma once

#include <vector>

#include "collision/geometry/shapes.h"
#include "collision/mesh/mesh_collider.h"

namespace campuswalk::collision {

struct PosedBox {
    Box box;
    Pose X_mesh_box;
};

/// The boxes at a level of the mesh's tree, for display: level 0 is the box of the root. A leaf also belongs
/// to all levels below its own.
std::vector<PosedBox> boxes_at_level(const MeshCollider& mesh, int level);

}  // namespace campuswalk::collision
