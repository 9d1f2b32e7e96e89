#pragma once

#include <span>

#include "collision/geometry/shapes.h"

namespace campuswalk::collision {

/// A wall that limits horizontal motion: at most `room` metres against its unit normal (x, z).
struct HalfPlane {
    double x = 0.0;
    double z = 0.0;
    double room = 0.0;  ///< not negative

    bool allows(const Vec3& move) const { return x * move.x() + z * move.z() >= -room - 1e-12; }
};

/// The horizontal move nearest to `desired` (y = 0) that all half-planes allow, whatever their order. They
/// always allow standing still.
Vec3 nearest_allowed(const Vec3& desired, std::span<const HalfPlane> planes);

}  // namespace campuswalk::collision
