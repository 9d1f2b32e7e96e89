#pragma once

#include "collision/mesh_collider.h"

namespace campuswalk::bench {

/// The whole demo campus as one mesh, about the middle of its bounds.
collision::MeshCollider load_demo_mesh();

}  // namespace campuswalk::bench
