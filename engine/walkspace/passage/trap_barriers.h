#pragma once

#include <vector>

#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/passage/traps.h"
#include "engine/walkspace/space/walk_space.h"
#include "engine/walkspace/stride/worker_worlds.h"
#include "scene/campus/node_triangles.h"

namespace campuswalk::engine {

/// Finds `Trap::out` of the first traps, the largest of a space, of which these are all. They share the
/// workers. `nodes`: what the meshes consist of.
void find_trap_barriers(const WorkerWorlds& worlds, const ExploreSettings& settings, const WalkSpace& space,
                        const scene::NodeTriangles& nodes, std::vector<Trap>& traps);

}  // namespace campuswalk::engine
