#pragma once

#include <vector>

#include "collision/geometry/triangle_mesh.h"
#include "engine/script/avatar.h"
#include "engine/walkspace/explore/explore.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// The avatar's body and pace at 60 ticks per second.
StrideSettings strides_of(const AvatarProfile& avatar = {});
ExploreSettings explore_from(const collision::Vec3& start, const AvatarProfile& avatar = {});
WalkSpace explored(const collision::World& world, const ExploreSettings& settings, std::size_t workers = 1);
/// From one start.
WalkSpace explored(const scene::Campus& campus, const collision::Vec3& start,
                   const AvatarProfile& avatar = {});

/// A campus of one solid mesh.
scene::Campus campus_of(collision::TriangleMesh mesh);
/// A floor of 20 m by 20 m with stairs to a landing, a ramp to a deck of 1.2 m, a wall with a door, a ledge
/// that one can only fall from, and a rim that leads out of the world.
scene::Campus varied_ground();
/// Where all of it can be reached from.
inline const collision::Vec3 kOnVariedGround(0.0, 0.0, 6.0);

/// In the order of the tiles.
std::vector<WalkNodeId> nodes_of(const WalkSpace& space);
/// At most so many of them, spread evenly.
std::vector<WalkNodeId> some_nodes(const WalkSpace& space, std::size_t count);
/// Whether the foot's cell has a node within 0.2 m of its height.
bool reaches(const WalkSpace& space, const collision::Vec3& foot);

}  // namespace campuswalk::engine
