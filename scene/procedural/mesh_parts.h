#pragma once

#include <cstdint>
#include <functional>

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::scene {

/// Adds simple bodies to a mesh, +Y up, each with corners of its own, facing outward.
class MeshParts {
public:
    /// `mesh` must outlive it.
    explicit MeshParts(collision::TriangleMesh& mesh) : mesh_(mesh) {}

    std::uint32_t add_point(const collision::Vec3& point);

    // Counter-clockwise as seen from the outside.
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
    void add_quad(const collision::Vec3& a, const collision::Vec3& b, const collision::Vec3& c,
                  const collision::Vec3& d);

    void add_box(const collision::Pose& X, const collision::Vec3& middle, const collision::Vec3& half);

    /// From the middle of its lower end upward, both ends open: they are in something else.
    void add_prism(const collision::Pose& X, const collision::Vec3& foot, double radius, double height,
                   int sides);

    /// An ellipsoid whose corners are `bump()` times their distance from the middle.
    void add_ball(const collision::Vec3& middle, const collision::Vec3& radii, int sides, int rings,
                  const std::function<double()>& bump);

private:
    collision::TriangleMesh& mesh_;
};

}  // namespace campuswalk::scene
