#pragma once

#include <vector>

#include "engine/walkspace/barrier/why_not.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/explore/unreached_ground.h"
#include "scene/campus/node_triangles.h"

namespace campuswalk::engine {

/// Ground that the body reaches, but not one as wide as wanted.
struct NarrowPassage {
    Island beyond;
    std::optional<Barrier> passage;  ///< none: nothing that the wide body reaches lies near
};

/// Walks everywhere once more, with a body of this width (metres), and compares. The largest ground first;
/// less than 1 m² is left out. The width is more than the body's own, and at most its height. `nodes` as in
/// PassageQuery.
std::vector<NarrowPassage> find_narrow_passages(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                                const WalkSpace& reached, double width,
                                                const scene::NodeTriangles* nodes);

}  // namespace campuswalk::engine
