#pragma once

#include <Eigen/Core>

#include "scene/model/scene_file.h"

struct aiScene;

namespace campuswalk::scene {

/// The transform from assimp's coordinates to the world frame (metres, +Y up).
///
/// What the file states comes first: assimp puts COLLADA's <unit> and <up_axis> into the root node, and
/// ignores FBX's UnitScaleFactor (in centimetres) and axes, which are applied here. `up`, `unit`, `scale` and
/// `position` of the campus file come on top. They are neutral by default: they are for formats that state
/// nothing (OBJ, STL, PLY) and for files that are wrong.
Eigen::Matrix4d world_from_file(const SceneFile& file, const aiScene& scene);

/// The same for a format in metres with +Y up: only what the campus file says.
Eigen::Matrix4d world_from_file(const SceneFile& file);

/// Whether an FBX file's axes are left-handed: then its geometry is read as if they were +X, +Y and +Z.
bool has_left_handed_axes(const aiScene& scene);

}  // namespace campuswalk::scene
