#pragma once

#include <span>

#include "collision/mover/ground_query.h"
#include "collision/mover/move_context.h"

namespace campuswalk::collision {

/// A horizontal displacement held against the walls.
struct Slide {
    Vec3 move = Vec3::Zero();
    std::span<const HalfPlane> walls;  ///< that held it; valid until the next slide
};

/// Flat walls always count; an edge counts only once the move would run into it, because an edge between two
/// flush faces isn't there for the avatar.
Slide slide(MoveContext& context, const Support& stand, const Vec3& desired, bool grounded);

}  // namespace campuswalk::collision
