#pragma once

#include <limits>
#include <optional>

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

/// A sphere at rest on top of something, world coordinates, metres.
struct SphereRest {
    double height = 0.0;     ///< y of the sphere's centre
    Vec3 on = Vec3::Zero();  ///< where it touches
};

/// Likewise on a face's plane. `up` is the face's normal, on its upper side; `vertex` is one of it.
inline SphereRest rest_on_face(const Vec3& vertex, const Vec3& up, double x, double z, double radius) {
    const double on_x = x - radius * up.x();
    const double on_z = z - radius * up.z();
    const double dx = on_x - vertex.x();
    const double dz = on_z - vertex.z();
    const double on_y = vertex.y() - (up.x() * dx + up.z() * dz) / up.y();
    return {on_y + radius * up.y(), {on_x, on_y, on_z}};
}

/// Where a sphere of `radius` that moves straight down at (x, z) from far above stops on the triangle; none
/// if it passes beside it. `normal` is the face's, on either side, or zero. Of edges within 1e-5 of upright,
/// only the ends count. Where its centre would stop below `useful`, there may be none, too, as that is sooner
/// known.
std::optional<SphereRest> sphere_rest(const Triangle& triangle, const Vec3& normal, double x, double z,
                                      double radius,
                                      double useful = -std::numeric_limits<double>::infinity());

}  // namespace campuswalk::collision
