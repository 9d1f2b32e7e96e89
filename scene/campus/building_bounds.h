#pragma once

#include <vector>

#include "scene/campus/campus.h"

namespace campuswalk::scene {

/// Where each building is, world frame: the bounds of its nodes; without nodes, those of its colliders that
/// are solid or seen, or else of its triggers. Empty without either: then nothing tells where it is.
std::vector<Bounds> building_bounds(const Campus& campus);

}  // namespace campuswalk::scene
