#pragma once

#include "collision/mover/move_context.h"

namespace campuswalk::collision {

// Whether straight motions of the body are free of what is near, which must have been surveyed for all of
// them. A plane that has the piece on one side and the body on the other at both ends of a motion clears it;
// only what no plane at hand clears is swept.

/// From one place of the foot to another.
bool is_free(MoveContext& context, const Vec3& from, const Vec3& to);

/// Up, across and down: what a round body rolls over is higher between two places than at both.
bool is_free_over(MoveContext& context, const Vec3& from, const Vec3& to);

/// The part of `move` that keeps `radius` about the core free.
Vec3 free_part(const MoveContext& context, const Vec3& foot, const Vec3& move, double radius);

/// Whether the body comes nearer than kRest to one piece, if it moves.
bool comes_near(MoveContext& context, ContactCache::Index i, const Vec3& foot, const Vec3& move);

}  // namespace campuswalk::collision
