#pragma once

#include <assimp/Importer.hpp>

#include "scene/base/diagnostic.h"
#include "scene/import/source/confined_files.h"
#include "scene/model/scene_file.h"

struct aiScene;

namespace campuswalk::scene {

/// A file read by assimp; `importer` owns it.
struct ReadScene {
    Assimp::Importer importer;
    ConfinedFiles* files = nullptr;  ///< owned by the importer
    const aiScene* scene = nullptr;
};

/// Whether COLLADA nodes are named by their `name` attribute, which authors see, or by their `id`. Nodes
/// without it get a name that starts with kGeneratedColladaName.
enum class ColladaNames { names, ids };
constexpr const char* kGeneratedColladaName = "$ColladaAutoName$";

/// Parses the file and triangulates polygons. No other post-processing: merging nodes would lose the names
/// that colliders refer to, and sanitize_mesh welds vertices and generates normals faster and exactly. Throws
/// InputError bad-model, and empty-mesh for an OBJ that is too short for assimp.
void read_scene(const SceneFile& file, const SceneFolder& folder, ReadScene& out,
                ColladaNames names = ColladaNames::names);

}  // namespace campuswalk::scene
