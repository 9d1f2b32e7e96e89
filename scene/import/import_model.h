#pragma once

#include <functional>
#include <vector>

#include "scene/base/diagnostic.h"
#include "scene/model/model.h"
#include "scene/model/model_file.h"
#include "scene/model/scene_file.h"

namespace campuswalk::scene {

/// What to do with a file that has no triangle at all: refused for walking, accepted for looking into.
enum class EmptyModel { refuse, accept };

/// Reads a model file into the house frame (glTF by gltf/, else through assimp): what the file says about its
/// units and up axis, then those of `file`, are applied (see file_frame.h), node transforms kept, textures
/// decoded. Node names survive as the file has them. Mirrored nodes (negative determinant) get meshes of
/// their own with the winding flipped, so that triangles are counter-clockwise from outside in the world.
/// Which other files a scene may draw in: see scene_folder.h. The same bytes give the same model.
///
/// Throws InputError (at `file.mark`), all mistakes of the file together, with code
///   missing-file   the file is not there or cannot be read
///   bad-model      its format isn't read, it needs a feature that isn't, it is damaged, or too large
///   empty-mesh     nothing in it has a triangle, or a mesh made for triangles has none
///   bad-vertex     a position or a node's transform is NaN or infinite, with the node's name
///   bad-texture    a texture is missing or cannot be decoded, with its material's name
/// Repairs and lints that do not stop a walk go to `warnings`:
///   points-and-lines   how many were left out
///   repaired-normals   normals that are zero or not finite, taken from the faces
///   repaired-uvs       texture coordinates that are not finite, set to 0
///   missing-materials  an OBJ's material file isn't there
///   unsupported-feature  what is passed over in a glTF file although the image or the shape needs it
///   bad-geography      a COLLADA file's geographic_location is none
///   unplaced-mesh      a glTF file without a default scene: meshes of no node are put at the origin
Model import_model(const SceneFile& file, std::vector<Diagnostic>& warnings,
                   EmptyModel if_empty = EmptyModel::refuse);

/// Likewise, with the files that the model depends on besides `file` itself.
ImportedModel import_model(const SceneFile& file, EmptyModel if_empty = EmptyModel::refuse);

/// How a scene file becomes a model, with import_model's errors: by import_model in this process, by a helper
/// process (helper/import_process.h), out of a cache.
using Importer = std::function<ImportedModel(const SceneFile& file, EmptyModel if_empty)>;

}  // namespace campuswalk::scene
