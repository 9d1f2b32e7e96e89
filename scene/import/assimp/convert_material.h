#pragma once

#include "scene/import/source/model_source.h"

struct aiMaterial;

namespace campuswalk::scene {

/// The diffuse colour becomes the base colour. Formats older than glTF have neither culling nor alpha modes:
/// their materials are double-sided, and blended if their opacity is below 1.
SourceMaterial convert_material(const aiMaterial& source);

}  // namespace campuswalk::scene
