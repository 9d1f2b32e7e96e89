#pragma once

#include <vector>

#include "scene/campus/campus.h"

namespace campuswalk::engine::render {

/// Bounds of each building's nodes, world frame; empty for a building without nodes.
std::vector<scene::Bounds> building_bounds(const scene::Campus& campus);

}  // namespace campuswalk::engine::render
