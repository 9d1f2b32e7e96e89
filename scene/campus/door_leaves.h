#pragma once

#include <vector>

#include "scene/campus/campus.h"
#include "scene/campus/node_selection.h"
#include "scene/model/upright_box.h"

namespace campuswalk::scene {

/// The leaf of a door, whether or not it is solid.
struct DoorLeaf {
    NodeRef node;
    UprightBox box;  ///< world
};

/// Nodes of the campus' models that are named as doors (is_door_name), each with its subtree, open doors too;
/// those without triangles are none. By model, then in order of nodes.
std::vector<DoorLeaf> find_door_leaves(const Campus& campus);

}  // namespace campuswalk::scene
