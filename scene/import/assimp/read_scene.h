#pragma once

#include <assimp/Importer.hpp>

#include "scene/base/diagnostic.h"
#include "scene/import/source/confined_files.h"
#include "scene/model/scene_file.h"

struct aiScene;

namespace campuswalk::scene {

/// A file as assimp sees it, alive as long as `importer`.
struct ReadScene {
    Assimp::Importer importer;
    ConfinedFiles* files = nullptr;  ///< owned by the importer
    const aiScene* scene = nullptr;
};

/// What COLLADA nodes are called by: the `name` that authors see, or the `id`. A node that lacks the one
/// asked for gets a name that starts with kMadeUpColladaName.
enum class ColladaNames { names, ids };
constexpr const char* kGeneratedColladaName = "$ColladaAutoName$";

/// Opens and parses the file; polygons are triangulated, nothing else is changed: no step runs that would
/// merge nodes (their names are what colliders go by), and joining vertices and making normals are done
/// after it, faster and exactly. Throws InputError bad-model, and
/// empty-mesh for an OBJ that is too short for assimp.
void read_scene(const SceneFile& file, const SceneFolder& folder, ReadScene& out,
                ColladaNames names = ColladaNames::names);

}  // namespace campuswalk::scene
