#pragma once

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

/// A filled convex solid for distance queries: all points within `radius` of a core about the pose's origin.
/// The core is a box; for a wheel, a segment along X with a perpendicular disc of radius `disc` at each of
/// its points.
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

// The distance between two convex bodies, metres; 0 if they share a point, touching included. Exact except
// for the rounding of double, which is proportional to the bodies' sizes and their distance, not to their
// place in the world. Beside a wheel's rim of radius r, a gap g may come out longer by 1e-14 r / g, and a gap
// below 1e-8 of the bodies' sizes may come out as 0.

double distance_between(const ConvexSolid& a, const ConvexSolid& b);
double distance_between(const ConvexSolid& solid, const Triangle& triangle);

}  // namespace campuswalk::collision
