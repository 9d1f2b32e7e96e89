#pragma once

#include <cstddef>
#include <vector>

#include "scene/lint/model_report.h"
#include "scene/model/model.h"
#include "scene/model/upright_box.h"

namespace campuswalk::scene {

struct FoundBuilding {
    std::vector<std::size_t> nodes;  ///< indices into Model::nodes, each with its subtree; ascending
    UprightBox box;                  ///< around all of them, world
};

/// The buildings of a model by its geometry and its names together. A node is one building if it is a house
/// (house_of) and holds no two houses of its own; a group that does is opened. Houses that stand in one
/// another are one, and parts that are no house by themselves, such as a wall or a roof, join the house that
/// they stand in or touch, or together with others that they touch become one. What is named as surroundings
/// takes no part, nor does a fence: what encloses several houses without a roof. What covers most of the
/// model is one only if there is no other. In the order of their first nodes.
std::vector<FoundBuilding> find_buildings(const Model& model, const ModelReport& report);

}  // namespace campuswalk::scene
