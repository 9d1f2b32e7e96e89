#pragma once

#include <vector>

#include "collision/geometry/shapes.h"
#include "collision/mesh/mesh_collider.h"

namespace campuswalk::collision {

struct PosedBox {
    Box box;
    Pose X_mesh_box;
};

/// The boxes at a level of the mesh's tree, to be shown: level 0 is the one around all of it. A leaf higher
/// up stays in the levels below it.
std::vector<PosedBox> boxes_at_level(const MeshCollider& mesh, int level);

}  // namespace campuswalk::collision
