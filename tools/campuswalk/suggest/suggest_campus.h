#pragma once

#include <filesystem>
#include <optional>

#include "config/loader/load_campus.h"
#include "scene/campus/campus_description.h"
#include "tools/campuswalk/suggest/campus_text.h"
#include "tools/campuswalk/suggest/suggested_walk.h"
#include "tools/campuswalk/suggest/upright_model.h"

namespace campuswalk::tools {

/// What to suggest a campus for, and where to write it.
struct SuggestRequest {
    std::filesystem::path campus_file;               ///< NAME.campus.yaml
    std::filesystem::path walk_file = {};            ///< empty: NAME.walk.yaml beside it
    bool overwrite = false;                          ///< replace it and the walk
    TypedFrame typed;                                ///< of the model
    std::optional<config::PlaceFile> places;         ///< GeoJSON that the campus is to refer to
    std::optional<scene::GeographicPlace> on_earth;  ///< of the campus's [0, 0, 0]; none: as the model says
};

/// What was suggested, and written.
struct Suggestion {
    std::filesystem::path campus_file;
    std::filesystem::path walk_file;
    UprightModel model = {};
    SuggestedCampus campus = {};
    PlayedWalk walk = {};
};

/// Writes a first campus for a model and a walk on it, which has been played and passes. Throws
/// scene::InputError as the import does, as reading the places does, and with the codes
///   file-name     the file is not called NAME.campus.yaml
///   file-exists   one of the two exists and must not be overwritten
///   no-ground     there is no place to stand
Suggestion suggest_campus(const scene::SceneFile& model, const SuggestRequest& request);

}  // namespace campuswalk::tools
