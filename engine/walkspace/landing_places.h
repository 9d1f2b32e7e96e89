#pragma once

#include <vector>

#include "engine/walkspace/unreached_surfaces.h"

namespace campuswalk::engine {

/// An edge that the body may leave the ground at, and how.
struct FallEdge {
    collision::Vec3 at = collision::Vec3::Zero();  ///< of the feet
    Gait gait = Gait::walk;
};

/// For each edge, whether a body that leaves the ground there and steers as it likes may land on a surface
/// that isn't reached yet. Where there is none, it is of no use to try how the fall may be
/// steered.
std::vector<bool> edges_above_new_ground(const collision::World& world, const ExploreSettings& settings,
                                         const WalkSpace& reached, const std::vector<FallEdge>& edges);

}  // namespace campuswalk::engine
