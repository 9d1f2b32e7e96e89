#pragma once

#include <vector>

#include "scene/base/diagnostic.h"
#include "scene/model/scene_file.h"
#include "scene/import/import_model.h"
#include "scene/import/source/model_source.h"

namespace campuswalk::scene {

/// Makes a Model of what a reader found: checks it, tidies its meshes, loads its textures. Errors and
/// warnings are those of import_model.
Model build_model(ModelSource& source, const SceneFile& file, std::vector<Diagnostic>& warnings,
                  EmptyModel if_empty);

}  // namespace campuswalk::scene
