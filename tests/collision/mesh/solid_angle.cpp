#include "tests/collision/mesh/solid_angle.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace campuswalk::collision {

double winding_number(const TriangleMesh& mesh, const Eigen::Vector3d& point) {
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle t = vertices(mesh, i);
        const Eigen::Vector3d a = t.a - point;
        const Eigen::Vector3d b = t.b - point;
        const Eigen::Vector3d c = t.c - point;
        const double la = a.norm();
        const double lb = b.norm();
        const double lc = c.norm();
        const double below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
        sum += 2.0 * std::atan2(a.dot(b.cross(c)), below);
    }
    return sum / (4.0 * std::numbers::pi);
}

}  // namespace campuswalk::collision
