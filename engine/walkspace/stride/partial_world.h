#pragma once

#include <memory>

#include "collision/geometry/shapes.h"
#include "collision/world/world.h"
#include "scene/campus/node_triangles.h"

namespace campuswalk::engine {

/// The world within a box, without some triangles of one object's mesh: what it would be like if a door were
/// open that is part of a building's mesh. Objects keep their ids; those outside aren't found. None if the
/// object has no other triangle there.
std::unique_ptr<collision::World> world_without(const collision::World& world, collision::ObjectId object,
                                                const scene::TriangleRange& triangles,
                                                const collision::Aabb& within);

}  // namespace campuswalk::engine
