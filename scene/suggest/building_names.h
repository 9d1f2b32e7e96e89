#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/model/model.h"
#include "scene/suggest/find_buildings.h"

namespace campuswalk::scene {

/// What each building is called in the model: the name of its only node, that of the lowest group which holds
/// all of its nodes and of no other building, or the beginning that the names of most of its nodes share.
/// Empty if those say nothing (is_default_name, is_identifier, generated names). One name for each building.
std::vector<std::string> names_of(const Model& model, const std::vector<FoundBuilding>& buildings);

/// Globs that match the nodes of each building, with their subtrees, and nothing else; none if the names
/// don't tell them from other nodes or there are over a hundred that share no beginning.
std::vector<std::vector<std::string>> globs_of(const Model& model,
                                               const std::vector<FoundBuilding>& buildings);

}  // namespace campuswalk::scene
