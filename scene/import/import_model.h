#pragma once

#include "scene/campus_description.h"
#include "scene/diagnostic.h"
#include "scene/model.h"

namespace campuswalk::scene {

/// Reads a model file through assimp into the house frame: units and up axis of `file` applied, node
/// transforms kept, textures decoded. Node names survive as the file has them.
///
/// Throws InputError (at `file.mark`) with code
///   missing-file   the file is not there or cannot be read
///   bad-model      assimp refuses it (its own words in the message)
///   empty-mesh     nothing in it has a triangle, or a mesh node has none
///   bad-vertex     a position is NaN or infinite, with the node's name
///   bad-texture    a texture is missing or cannot be decoded, with its material's name
/// Repairs and oddities that do not stop a walk go to `warnings`.
Model import_model(const SceneFile& file, std::vector<Diagnostic>& warnings);

}  // namespace campuswalk::scene
