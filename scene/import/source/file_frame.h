#pragma once

#include <Eigen/Core>

#include "scene/model/scene_file.h"

struct aiScene;

namespace campuswalk::scene {

/// The transform from what assimp hands out to the house frame (metres, +Y up).
///
/// What a file says about itself comes first: glTF is in metres with +Y up, assimp puts COLLADA's <unit> and
/// <up_axis> into the root node, and FBX's UnitScaleFactor (in centimetres) and axes, which assimp
/// passes over, are applied here. `up`, `unit`, `scale` and `position` of the campus file come on top and are
/// neutral by default, so they are for formats that say nothing (OBJ, STL, PLY) and for files that are wrong
/// about themselves.
Eigen::Matrix4d world_from_file(const SceneFile& file, const aiScene& scene);

/// Likewise for a file that is in the house frame by itself: what the campus file says of it.
Eigen::Matrix4d world_from_file(const SceneFile& file);

}  // namespace campuswalk::scene
