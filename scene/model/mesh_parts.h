#pragma once

#include <cstdint>
#include <functional>

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::scene {

/// Appends simple shapes to a mesh, +Y up, facing outward. Shapes share no vertices.
class MeshParts {
public:
    /// `mesh` must outlive it.
    explicit MeshParts(collision::TriangleMesh& mesh) : mesh_(mesh) {}

    std::uint32_t add_point(const collision::Vec3& point);

    // Counter-clockwise seen from outside.
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
    void add_quad(const collision::Vec3& a, const collision::Vec3& b, const collision::Vec3& c,
                  const collision::Vec3& d);

    void add_box(const collision::Pose& X, const collision::Vec3& center, const collision::Vec3& half);

    /// Upward from the centre of its base. Both ends are open, since they are inside something else.
    void add_prism(const collision::Pose& X, const collision::Vec3& foot, double radius, double height,
                   int sides);

    /// An ellipsoid; each vertex is scaled by `bump()` about the centre.
    void add_ball(const collision::Vec3& center, const collision::Vec3& radii, int sides, int rings,
                  const std::function<double()>& bump);

    /// A height field of `cells` x `cells` square cells of side `step`, from x = z = `low`.
    void add_terrain(int cells, double low, double step,
                     const std::function<double(double x, double z)>& height);

private:
    collision::TriangleMesh& mesh_;
};

}  // namespace campuswalk::scene
