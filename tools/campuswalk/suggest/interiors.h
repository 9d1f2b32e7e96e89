#pragma once

#include <optional>
#include <vector>

#include "engine/walkspace/space/rooms.h"
#include "engine/walkspace/space/walk_space.h"
#include "scene/campus/campus.h"
#include "scene/suggest/suggested_buildings.h"

namespace campuswalk::tools {

/// A level floor behind doorways.
struct SuggestedRoom {
    scene::UprightBox box;     ///< about where a visitor's foot gets to, up to 2 m above it
    engine::WalkNodeId place;  ///< of its floor, near the middle
};

/// What a visitor gets to of a building.
struct Interior {
    /// Inside, near its middle and on its lowest storey; none if it can't be entered.
    std::optional<engine::WalkNodeId> place;
    /// From the lowest storey up, each storey's in the order in which they were reached. Empty if there are
    /// fewer than two: then the building is its only room.
    std::vector<SuggestedRoom> rooms;
};

/// By building. Inside is where there are walls in five of eight directions under a roof, or in seven without
/// one. A room has a box, over a metre wide, that holds hardly any other room's floor, and fills half of it.
std::vector<Interior> find_interiors(const scene::Campus& campus, const engine::WalkSpace& reached,
                                     const std::vector<scene::SuggestedBuilding>& buildings,
                                     const std::vector<engine::KnownDoor>& doors);

}  // namespace campuswalk::tools
