#pragma once

#include "scene/cache/content_hash.h"
#include "scene/model/model.h"
#include "scene/model/scene_file.h"

namespace campuswalk::scene {

/// Puts an imported model where the scene's placements say: its nodes once for each, below a node with the
/// placement's name; meshes are shared. Throws InputError (bad-model) if these are more nodes or triangles
/// than a model may have.
void place_scene(const SceneFile& scene, Model& model);

/// The hash of a model's contents and of how the scene places it; that of the contents alone if it doesn't
/// say.
ContentHash placed_contents(const SceneFile& scene, const ContentHash& contents);

}  // namespace campuswalk::scene
