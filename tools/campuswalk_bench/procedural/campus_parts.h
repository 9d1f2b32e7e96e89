#pragma once

#include "collision/geometry/shapes.h"
#include "scene/model/mesh_parts.h"
#include "tools/campuswalk_bench/procedural/split_mix.h"

namespace campuswalk::tools::bench {

// Building blocks of procedural campuses.

constexpr double kStorey = 3.5;  ///< metres

/// The pose at `at` with a yaw about +Y, radians.
collision::Pose pose_with_yaw(const collision::Vec3& at, double yaw);

/// The height of rolling terrain, at most 4.2 m from 0.
double rolling_ground(double x, double z);

/// A wall with windows of about 3 m that are recessed by 0.25 m, from x = -half to half and from y = 0 up.
/// X's z points outside.
void add_window_wall(scene::MeshParts& parts, const collision::Pose& X_campus_wall, double half, int storeys);

/// A trunk, a bumpy crown with a radius up to 3 m, and leaves that stick out of it, varied by `random`.
void add_tree(scene::MeshParts& parts, const collision::Vec3& foot, SplitMix& random);

/// 1.8 m long, along X's x.
void add_bench(scene::MeshParts& parts, const collision::Pose& X);

/// 4.2 m high, with its arm along X's z.
void add_lamp(scene::MeshParts& parts, const collision::Pose& X);

}  // namespace campuswalk::tools::bench
