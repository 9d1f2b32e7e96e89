#pragma once

#include <vector>

#include "scene/campus/campus.h"

namespace campuswalk::engine::render {

/// World-space boxes of the buildings' nodes, one a building; empty for a building that names no nodes.
std::vector<scene::Bounds> building_bounds(const scene::Campus& campus);

}  // namespace campuswalk::engine::render
