#pragma once

#include <span>

#include "collision/mover/ground_query.h"
#include "collision/mover/move_context.h"

namespace campuswalk::collision {

/// A horizontal displacement that walls have shortened.
struct Slide {
    Vec3 move = Vec3::Zero();
    std::span<const HalfPlane> walls;  ///< that may have shortened it; valid until the next slide
    bool overhung = false;  ///< some of them are ceilings, which don't stop a body that goes down far enough
};

/// Whether what hangs over the body counts as a wall: it stops a body that stays at its height.
enum class Overhangs { stop, pass };

/// Flat walls always count; an edge counts only if the move would run into it, because an edge between two
/// flush faces must not stop the avatar.
Slide slide(MoveContext& context, const Support& stand, const Vec3& desired, bool grounded,
            Overhangs overhangs = Overhangs::stop);

}  // namespace campuswalk::collision
