#pragma once

#include <span>
#include <vector>

#include "collision/geometry/shapes.h"
#include "collision/world/world.h"
#include "engine/walkspace/space/walk_space.h"

namespace campuswalk::engine {

/// Where a leaf hangs or hung: a doorway, though there may be no lintel above.
struct KnownDoor {
    collision::Vec3 foot = collision::Vec3::Zero();  ///< of its middle, world
    double width = 0.0;                              ///< metres
};

/// A level floor that one leaves by doorways, steps or ramps only.
struct Room {
    std::vector<WalkNodeId> nodes;  ///< by tile and node, without those in doorways
};

/// The rooms whose floors are in the box, seen from above and by height, in the order in which they were
/// reached; ground outside of buildings counts as one. A doorway is a known door of at most 2.5 m, or a
/// passage of at most 1.6 m between walls that is wider in front and behind, or has a lintel: there the room
/// above one's head is lower than in front and behind. Furniture lower than a head is no wall.
std::vector<Room> find_rooms(const collision::World& world, const WalkSpace& reached,
                             const collision::Aabb& within, std::span<const KnownDoor> doors);

}  // namespace campuswalk::engine
