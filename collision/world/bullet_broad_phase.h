#pragma once

#include <memory>

#include "collision/world/broad_phase.h"

namespace campuswalk::collision {

/// Bullet's dynamic AABB tree (btDbvtBroadphase). Boxes are rounded outward to Bullet's float32. Not safe for
/// queries from several threads at once: Bullet keeps the traversal's stack in the tree.
std::unique_ptr<BroadPhase> make_bullet_broad_phase();

}  // namespace campuswalk::collision
