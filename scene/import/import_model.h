#pragma once

#include <functional>

#include "scene/model/model_file.h"
#include "scene/model/scene_file.h"

namespace campuswalk::scene {

/// Whether a file without triangles is an error (to walk in it) or a warning (to inspect it).
enum class EmptyModel { refuse, accept };

/// Imports a model file into the world frame: glTF by gltf/, other formats through assimp. Applies the units
/// and up axis that the file states, then those of `file` (see file_frame.h). Keeps node names and
/// transforms, decodes textures, and replaces the meshes of mirrored nodes (mirror_meshes.h). scene_folder.h
/// says which other files a model may read. The same bytes give the same model.
///
/// Throws InputError (at `file.mark`) with all errors of the file; the codes are
///   missing-file   the file does not exist or cannot be read
///   bad-model      unsupported format or feature, damaged, or too large
///   empty-mesh     the file or one of its meshes has no triangles
///   bad-vertex     a position or a node's transform is NaN or infinite; names the node
/// Repairs and omissions become warnings:
///   bad-texture          a texture is missing or cannot be decoded: the surface is plain; names the material
///   points-and-lines     ignored primitives
///   repaired-normals     zero or non-finite normals, replaced by face normals
///   repaired-uvs         non-finite texture coordinates, set to 0
///   missing-materials    an OBJ's material file does not exist
///   unsupported-feature  ignored glTF features that affect the shape or the image
///   missing-data         glTF arrays without data, read as zeros
///   bad-geography        an invalid geographic_location in a COLLADA file
///   unplaced-mesh        glTF meshes that no node places
ImportedModel import_model(const SceneFile& file, EmptyModel if_empty = EmptyModel::refuse);

/// How to get the model of a scene file: import_model in this process, in a helper process
/// (helper/import_process.h), or from a cache. Throws as import_model does.
using Importer = std::function<ImportedModel(const SceneFile& file, EmptyModel if_empty)>;

}  // namespace campuswalk::scene
