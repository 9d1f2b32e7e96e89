#pragma once

#include <vector>

#include "scene/campus_description.h"
#include "scene/diagnostic.h"
#include "scene/import/import_model.h"
#include "scene/import/model_source.h"

namespace campuswalk::scene {

/// Makes a Model of what a reader found: checks it, tidies its meshes, loads its textures. Errors and
/// warnings are those of import_model.
Model build_model(ModelSource& source, const SceneFile& file, std::vector<Diagnostic>& warnings,
                  EmptyModel if_empty);

}  // namespace campuswalk::scene
