#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/campus/campus.h"

namespace campuswalk::engine::render {

/// The building and object that a pixel or node belongs to.
struct PixelOwner {
    std::optional<std::size_t> building;  ///< index into CampusDescription::buildings
    std::optional<std::size_t> object;    ///< index into Campus::objects

    bool operator==(const PixelOwner&) const = default;
};

/// The owners of a campus' nodes. Buildings and objects claim nodes with their subtrees; a node goes to the
/// claimant with the fewest nodes, so a door that is an object belongs to that rather than to its house. Ties
/// go to the first in the file, and objects that are only triggers, hence invisible, come last. A node
/// without a building belongs to its object's building.
struct NodeOwners {
    std::vector<PixelOwner> owners;            ///< [0] is no owner; ordered by building, then object
    std::vector<std::uint32_t> owner_of_node;  ///< index into `owners` by node number (Channels::nodes)
};

NodeOwners find_node_owners(const scene::Campus& campus);

}  // namespace campuswalk::engine::render
