#pragma once

#include <string>
#include <vector>

#include "scene/lint/model_report.h"
#include "scene/model/model.h"
#include "scene/model/upright_box.h"

namespace campuswalk::scene {

/// A named node that is probably a building.
struct SuggestedBuilding {
    std::string id;    ///< kebab-case, unique; `building-1`, … if the name is an identifier
    std::string node;  ///< its name, which is unique
    std::string glob;  ///< matches this node only
    UprightBox box;    ///< world
};

/// The topmost nodes with a unique name that have the height of a storey, the width of a room, and walls, are
/// not most of the model, and are not named as surroundings (is_surroundings_name). The forty with the
/// largest footprint, in the order of the file.
std::vector<SuggestedBuilding> suggest_buildings(const Model& model, const ModelReport& report);

}  // namespace campuswalk::scene
