#pragma once

#include <string>
#include <vector>

#include "scene/model.h"
#include "scene/model_report.h"

namespace campuswalk::scene {

/// A named node that may well be a building.
struct SuggestedBuilding {
    std::string id;    ///< kebab-case, distinct
    std::string node;  ///< its name, which no other node has
    std::string glob;  ///< that matches it and nothing else
    Bounds bounds;     ///< world
};

/// The topmost nodes with a name of their own that are as high as a storey and as wide as a room, and not
/// most of the whole; the forty that cover most ground, in the order of the file.
std::vector<SuggestedBuilding> suggest_buildings(const ModelReport& report);

}  // namespace campuswalk::scene
