#pragma once

#include <optional>

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

/// A ray as a segment: `fraction` 0 is at `from`, 1 at `to`. Surfaces are two-sided.
/// A ray that starts inside a solid hits it at fraction 0.
struct Ray {
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
};

/// Watertight: a ray through a shared edge hits at least one of its triangles (Woop, Benthin, Wald 2013).
std::optional<double> hit(const Ray& ray, const Triangle& triangle);

// Solids in their own frame.

std::optional<double> hit(const Ray& ray, const Box& box);
std::optional<double> hit(const Ray& ray, const Sphere& sphere);
std::optional<double> hit(const Ray& ray, const Capsule& capsule);
std::optional<double> hit(const Ray& ray, const Wheel& wheel);

}  // namespace campuswalk::collision
