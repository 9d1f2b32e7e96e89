#include "scene/campus/collider_globs.h"

#include <algorithm>

#include "scene/campus/collider_shapes.h"

namespace campuswalk::scene {

std::optional<std::size_t> building_of(const CampusDescription& campus, const ColliderDescription& collider) {
    const auto found = std::ranges::find(campus.buildings, collider.building, &Building::id);
    if (collider.building.empty() || found == campus.buildings.end()) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - campus.buildings.begin());
}

const std::vector<NodeGlob>& globs_of(const CampusDescription& campus, const ColliderDescription& collider) {
    const auto building = building_of(campus, collider);
    if (collider.nodes.empty() && building && !is_placed_by_numbers(collider.shape)) {
        return campus.buildings[*building].nodes;
    }
    return collider.nodes;
}

}  // namespace campuswalk::scene
