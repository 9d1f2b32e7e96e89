#pragma once

#include <span>
#include <vector>

#include "collision/mover/mover_settings.h"
#include "collision/world/obstacle.h"
#include "engine/walkspace/stride/stride.h"
#include "scene/campus/node_triangles.h"

namespace campuswalk::engine {

/// A node that is part of an object's mesh, and where it is nearest to a body.
struct RemovableNode {
    collision::ObjectId object{};
    scene::TriangleRange triangles;
    std::uint32_t triangle = 0;  ///< one of them: the nearest
    double distance = 0.0;       ///< from a body's core, metres
    collision::Vec3 at = collision::Vec3::Zero();
};

/// A node that is no larger is rather a door or a bench than a wall of a building, metres: the diagonal of
/// its bounds.
inline constexpr double kSmallNode = 5.0;

/// Nodes right beside bodies that stand there, which don't carry them and are no larger than `largest`,
/// metres. The nearest few, the smallest of these first.
std::vector<RemovableNode> removable_nodes(const collision::World& world,
                                           const collision::QueryFilter& solids,
                                           const collision::MoverSettings& body,
                                           const scene::NodeTriangles& nodes,
                                           std::span<const GroundState> bodies, double largest);

/// Of the object's triangles in the world.
collision::Aabb bounds_of(const collision::World& world, collision::ObjectId object,
                          const scene::TriangleRange& triangles);

/// Whether a body of this radius that stands there is carried by what it is nearest to in `c`.
bool carries(const GroundState& at, const collision::Closest& c, double radius);

}  // namespace campuswalk::engine
