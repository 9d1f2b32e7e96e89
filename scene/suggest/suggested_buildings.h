#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/lint/model_report.h"
#include "scene/model/model.h"
#include "scene/model/upright_box.h"

namespace campuswalk::scene {

/// What is probably a building, named as a person would.
struct SuggestedBuilding {
    std::string id;     ///< as to_id_word, unique; `building-1`, … if nothing names it
    std::string title;  ///< what names it in the model; `Building 1`, … if nothing does
    /// Match its nodes and no others; empty if they can't be told by their names.
    std::vector<std::string> globs;
    bool is_one_node = true;  ///< with its subtree
    UprightBox box;           ///< world
};

struct SuggestedBuildings {
    std::vector<SuggestedBuilding> list;
    std::size_t left_out = 0;  ///< further ones without names
};

/// The buildings of find_buildings in the order of the file: all whose names say something, and of the others
/// the forty with the largest footprint. A name is the node's own, that of a group which holds all of the
/// building and no other, or the beginning that its nodes' names share; that of the file if there is but one.
SuggestedBuildings suggest_buildings(const Model& model, const ModelReport& report);

}  // namespace campuswalk::scene
