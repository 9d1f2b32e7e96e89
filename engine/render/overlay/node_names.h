#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/campus/campus.h"

namespace campuswalk::engine::render {

/// Who a pixel of an id image belongs to.
struct PixelOwner {
    std::optional<std::size_t> building;  ///< index into CampusDescription::buildings
    std::optional<std::size_t> object;    ///< index into Campus::objects

    bool operator==(const PixelOwner&) const = default;
};

/// The names of a campus' nodes. Of the buildings and of the objects that take a node, each with its subtree,
/// the one that takes the fewest nodes names it: a door that is an object of its own is that, not its house.
/// Of equals the first in the file; what is only a trigger, and so nothing to see, last of all. A node that
/// no building names belongs to its object's.
struct NodeOwners {
    std::vector<PixelOwner> names;             ///< [0] is nobody's; ordered by building, then object
    std::vector<std::uint32_t> owner_of_node;  ///< by the node's number in Channels::nodes; [0] is 0
};

NodeOwners name_nodes(const scene::Campus& campus);

}  // namespace campuswalk::engine::render
