#pragma once

#include <optional>
#include <vector>

#include "engine/walkspace/report/ground_cover.h"
#include "scene/lint/model_report.h"
#include "scene/suggest/suggested_buildings.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/suggest/upright_model.h"

namespace campuswalk::tools {

/// The named points of a file of places.
struct PlaceCount {
    std::size_t named = 0;
    std::size_t within_bounds = 0;  ///< of the model, in the plan
};

/// What `campuswalk info` says about a model.
struct ModelInfo {
    UprightModel upright;
    std::optional<engine::GroundCover> ground;
    scene::SuggestedBuildings buildings;
    std::optional<PlaceCount> places = {};  ///< if a file of them was named
};

/// As config/schema/info.schema.json says.
Json json_of(const ModelInfo& info);

/// Prints what matters to visitors first: size, ground, buildings, doors and stairs; then what it is made of.
void print_text(const ModelInfo& info);

}  // namespace campuswalk::tools
