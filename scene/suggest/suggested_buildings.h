#pragma once

#include <string>
#include <vector>

#include "scene/model/model.h"
#include "scene/model/model_report.h"
#include "scene/model/upright_box.h"

namespace campuswalk::scene {

/// A named node that may well be a building.
struct SuggestedBuilding {
    std::string id;    ///< kebab-case, distinct; `building-1`, … where the name is an identifier
    std::string node;  ///< its name, which no other node has
    std::string glob;  ///< that matches it and nothing else
    UprightBox box;    ///< world
};

/// The topmost nodes with a name of their own that are as high as a storey, as wide as a room, have walls and
/// are neither most of the whole nor called a tree, a fence or the like; the forty that cover most ground, in
/// the order of the file.
std::vector<SuggestedBuilding> suggest_buildings(const Model& model, const ModelReport& report);

}  // namespace campuswalk::scene
