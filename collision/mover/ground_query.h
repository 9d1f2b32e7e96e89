#pragma once

#include "collision/mover/move_context.h"

namespace campuswalk::collision {

/// Where the body stands, and the height that edges count from.
struct Support {
    Vec3 foot = Vec3::Zero();
    double base = 0.0;  ///< of what carries it; not below the foot
};

/// What a body that comes straight down would stand on.
struct Ground {
    bool found = false;    ///< something is there
    bool carries = false;  ///< and can be stood on
    double foot_y = 0.0;   ///< where the foot comes to rest, kRest above it
    double at = 0.0;       ///< height of the highest point that carries
};

// Tells ground from walls, by the faces of what the body would touch, not by where it touches them: edges as
// high as a step allows carry if a walkable face ends there, and no edge is climbed that is higher, however
// round the body is.

/// How far sideways of the body `classify` looks, metres: what is near must have been surveyed for it.
inline constexpr double kProbe = 0.06;

/// Looks among what is near for the highest ground at (x, z) up to `up` above and `down` below where the body
/// stands now.
Ground find_ground(MoveContext& context, double x, double z, const Support& stand, double up, double down);

/// What a piece near the body is to it.
Kind classify(MoveContext& context, ContactCache::Index i, const Support& stand);

}  // namespace campuswalk::collision
