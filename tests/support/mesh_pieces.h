#pragma once

#include <memory>

#include "collision/mesh/mesh_collider.h"
#include "collision/world/world.h"

/// Building blocks of test scenes, metres, +Y up.
namespace campuswalk::support {

using collision::TriangleMesh;
using Eigen::Vector3d;

/// Counter-clockwise seen from the front.
void add_triangle(TriangleMesh& mesh, const Vector3d& a, const Vector3d& b, const Vector3d& c);
void add_quad(TriangleMesh& mesh, const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d);
/// Closed, facing outward.
void add_box(TriangleMesh& mesh, const Vector3d& min, const Vector3d& max);
/// A level square about the origin, at height `y`, in cells of `cell` metres.
void add_floor(TriangleMesh& mesh, double half_size, double y = 0.0, double cell = 1e9);
/// A level floor of 80 m by 80 m at height 0, and what `add` adds to it.
template <typename Add>
TriangleMesh floor_with(const Add& add) {
    TriangleMesh mesh;
    add_floor(mesh, 40.0);
    add(mesh);
    return mesh;
}
/// Treads and risers that rise along +X from (x, 0), between z and z + width; ends with a landing of a metre.
void add_stairs(TriangleMesh& mesh, double x, double z, double width, double riser, double tread, int steps);
/// Four walls around [min, max] with a door of `door` metres in the middle of the side at max.z, no roof.
void add_room(TriangleMesh& mesh, const Vector3d& min, const Vector3d& max, double door);

collision::ObjectId add_object(collision::World& world, TriangleMesh mesh,
                               collision::Detection detection = collision::Detection::solid,
                               const collision::Pose& X_world_shape = {});
collision::ObjectId add_object(collision::World& world, const collision::Shape& shape,
                               const Vector3d& position);

/// A right-handed rotation about a non-zero axis, radians.
collision::Mat3 turn(const Vector3d& axis, double angle);

}  // namespace campuswalk::support
