#pragma once

#include "collision/mover/move_context.h"

namespace campuswalk::collision {

// Whether straight motions of the body are free of the surveyed pieces; the survey must include all of the
// motion. A plane with the piece on one side and the body on the other at both ends of a motion clears it;
// the body is swept against a piece only if no cached plane clears it.

/// From one place of the foot to another.
bool is_free(MoveContext& context, const Vec3& from, const Vec3& to);

/// Up, across and down: an edge that a round body rolls over is higher between two places than at both.
bool is_free_over(MoveContext& context, const Vec3& from, const Vec3& to);

/// Along two tangents of the arc on which the body rolls over an edge: under a ceiling there may be no room
/// to go up first.
bool is_free_around_edge(MoveContext& context, const Vec3& from, const Vec3& to);

/// The part of `move` during which everything stays at least `radius` from the core.
Vec3 free_part(const MoveContext& context, const Vec3& foot, const Vec3& move, double radius);

/// Whether `move` brings the body nearer than kRestGap to a piece.
bool comes_near(MoveContext& context, ContactCache::Index i, const Vec3& foot, const Vec3& move);

}  // namespace campuswalk::collision
