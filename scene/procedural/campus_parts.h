#pragma once

#include "collision/geometry/shapes.h"
#include "scene/procedural/mesh_parts.h"
#include "scene/procedural/split_mix.h"

namespace campuswalk::scene {

// What stands on campuses that are made by formulas.

constexpr double kStorey = 3.5;  ///< metres

/// Yaw about +Y, radians.
collision::Pose turned(const collision::Vec3& at, double yaw);

/// The height of rolling ground, within 4.2 m of 0.
double rolling_ground(double x, double z);

/// A wall of windows 3 m wide that lie 0.25 m behind it, seen from its outside: X's z points there, its x to
/// the right; from x = -half to half, y = 0 to the top.
void add_window_wall(MeshParts& parts, const collision::Pose& X_campus_wall, double half, int storeys);

/// A trunk, a bumpy crown up to 3 m around it, and leaves that stick out of it. Whatever differs between
/// trees is by `chance`.
void add_tree(MeshParts& parts, const collision::Vec3& foot, SplitMix& chance);

/// 1.8 m long, along X's x.
void add_bench(MeshParts& parts, const collision::Pose& X);

/// 4.2 m high, its lamp towards X's z.
void add_lamp(MeshParts& parts, const collision::Pose& X);

}  // namespace campuswalk::scene
