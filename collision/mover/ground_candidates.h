#pragma once

#include <cstdint>
#include <span>

#include "collision/mover/ground_query.h"
#include "collision/mover/move_context.h"

namespace campuswalk::collision {

/// Fills the lists with the surveyed pieces that may carry a body up to kProbeDistance beside where it
/// stands, with its foot up to `up` above and `down` below there.
void list_candidates(MoveContext& context, const Support& stand, double up, double down);

/// Where a sphere moves straight down, about the place where the body stands: at (x, z), with its centre
/// between `useful` and `highest`.
struct Descent {
    float x = 0.0F;
    float z = 0.0F;
    float useful = 0.0F;
    float highest = 0.0F;
};

/// Chooses those of the candidates that the sphere may come to rest on: not those beside its way, not those
/// that are too low, and not those all of which is so near to its centre, were that at `highest`, that it
/// comes to rest above it. Returns indices into its lists, some beyond their end.
std::span<const std::uint32_t> choose_candidates(GroundCandidates& ground, double reach,
                                                 const Descent& descent);

}  // namespace campuswalk::collision
