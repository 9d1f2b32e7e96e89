#pragma once

#include "collision/mover/move_context.h"

namespace campuswalk::collision {

/// Where the body stands, and the height that edges are measured from.
struct Support {
    Vec3 foot = Vec3::Zero();
    double base =
        0.0;  ///< height of what carries the body; not below the foot, which is kRestGap above flat ground
};

/// What a body that moves straight down would come to rest on.
struct Ground {
    bool found = false;      ///< there is something
    bool carries = false;    ///< and the body can stand on it
    double foot_y = 0.0;     ///< where the foot comes to rest, kRestGap above it
    double support_y = 0.0;  ///< height of the highest point that carries
};

/// How far beside the body `classify` looks, metres: the survey must include that.
inline constexpr double kProbeDistance = 0.06;

/// A contact this low beside the sphere's centre, as a share of its radius, doesn't support it: with a radius
/// 15 µm smaller, there would be none.
inline constexpr double kMinSupportDrop = 0.01;
/// Nor does it catch a body that falls: an edge that overlaps it by 0.4 mm is a wall that isn't quite flush.
/// One that walks needs less, as it may go along a step and onto it by as little in a tick.
inline constexpr double kMinLandingDrop = 0.05;

/// The highest ground at (x, z), among the surveyed pieces, up to `up` above and `down` below where the body
/// stands now. `min_drop` is one of the two above.
Ground find_ground(MoveContext& context, double x, double z, const Support& stand, double up, double down,
                   double min_drop = kMinSupportDrop);

/// The same up to a step above `stand` and hardly below, for several (x, z) in turn, each no farther from
/// `stand` than kProbeDistance: faster where many pieces are near.
Ground find_ground_beside(MoveContext& context, double x, double z, const Support& stand);

/// Floor, step or wall? Decided by the faces of the piece, not by where the round body touches it: an edge up
/// to `step_height` and kHeightSlack above `stand.base` is a step if a walkable face ends there, and a higher
/// one is a wall, although the body could roll over it.
PieceKind classify(MoveContext& context, ContactCache::Index i, const Support& stand);

}  // namespace campuswalk::collision
