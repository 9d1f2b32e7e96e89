#pragma once

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

/// A filled convex solid as a distance sees it: all that is within `radius` of a core about the pose's
/// origin. The core is a box; of a wheel, a segment along X with a disc at right angles all along it.
struct ConvexSolid {
    Pose X_world_solid;
    Vec3 half_extents = Vec3::Zero();
    double disc = 0.0;
    double radius = 0.0;
};

ConvexSolid convex_solid(const Box& box, const Pose& X_world_shape);
ConvexSolid convex_solid(const Sphere& sphere, const Pose& X_world_shape);
ConvexSolid convex_solid(const Capsule& capsule, const Pose& X_world_shape);
ConvexSolid convex_solid(const Wheel& wheel, const Pose& X_world_shape);

// How far two convex bodies are apart, metres; 0 where they share a point, touching included. Exact but for
// the rounding of double, which is in proportion to the bodies' sizes and their distance, not to where they
// are in the world. Beside a wheel's rim of radius r, a gap g may be found longer by 1e-14 r / g, and one of
// less than 1e-8 of the bodies' sizes may count as none.

double distance_between(const ConvexSolid& a, const ConvexSolid& b);
double distance_between(const ConvexSolid& solid, const Triangle& triangle);

}  // namespace campuswalk::collision
