#pragma once

#include <string>
#include <vector>

#include "scene/model/model.h"
#include "scene/suggest/suggested_buildings.h"

namespace campuswalk::scene {

/// What is solid besides the buildings, so that each has a name of its own in the log.
struct SolidParts {
    std::vector<std::string> globs;  ///< match nodes, each of which stands for its subtree, and no others
    bool is_all = true;              ///< false: other nodes have triangles, too, but no names to tell them by
    bool are_the_rest = false;       ///< they are all roots that are no building's, so `*` matches them
};

/// The topmost nodes that a person would name: collections that hold buildings, and groups whose name says
/// nothing, are opened. No more than 300; where there are more, their groups are left whole. `doors` are the
/// names of nodes that aren't solid.
SolidParts solid_parts(const Model& model, const std::vector<SuggestedBuilding>& buildings,
                       const std::vector<std::string>& doors);

}  // namespace campuswalk::scene
