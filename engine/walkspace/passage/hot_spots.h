#pragma once

#include <cstddef>
#include <vector>

#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/space/walk_space.h"
#include "engine/walkspace/stride/worker_worlds.h"

namespace campuswalk::engine {

/// Reached ground where so much lies within a step's reach of the body that each tick there takes long: a
/// hedge of leaves that collide one by one.
struct HotSpot {
    collision::Vec3 foot = collision::Vec3::Zero();
    std::size_t pieces = 0;        ///< triangles and convex solids near the body
    collision::ObjectId object{};  ///< that most of them are of
};

/// Places with more than 300 pieces, of a sample, at least 8 m apart; the hottest first, at most ten. On most
/// campuses the body has fewer than ten around it.
std::vector<HotSpot> find_hot_spots(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                    const WalkSpace& space);

}  // namespace campuswalk::engine
