#pragma once

#include <optional>
#include <vector>

#include "engine/walkspace/walk_space.h"
#include "scene/campus/campus.h"
#include "scene/suggest/suggested_buildings.h"

namespace campuswalk::tools {

/// By building: a place inside it that a visitor reaches, near its middle and on its lowest storey; none if
/// it can't be entered. Inside is where there are walls in five of eight directions under a roof, or in seven
/// without one.
std::vector<std::optional<engine::WalkNodeId>> find_interiors(
    const scene::Campus& campus, const engine::WalkSpace& reached,
    const std::vector<scene::SuggestedBuilding>& buildings);

}  // namespace campuswalk::tools
