#pragma once

#include "scene/import/source/model_source.h"

struct aiMaterial;

namespace campuswalk::scene {

/// The diffuse colour is the base colour. Formats older than glTF know neither culling nor alpha modes: their
/// materials are drawn from both sides, and as blended when their opacity is below 1.
SourceMaterial convert_material(const aiMaterial& source);

}  // namespace campuswalk::scene
