#include "collision/geometry/triangle_box_overlap.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace campuswalk::collision {

namespace {

bool separated_along(const Vec3& axis, const Triangle& t, const Vec3& half) {
    const double a = axis.dot(t.a);
    const double b = axis.dot(t.b);
    const double c = axis.dot(t.c);
    const double reach = axis.cwiseAbs().dot(half);
    return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
}

}  // namespace

// Thirteen axes: the box's three, the triangle's normal, and those perpendicular to an edge of each
// (Akenine-Moeller, "Fast 3D triangle-box overlap testing", 2001). For a triangle without area some have no
// length and separate nothing; the others separate segments and points.
bool overlap(const Triangle& t, const Box& box) {
    const Vec3& half = box.half_extents;
    for (int k = 0; k < 3; ++k) {
        if (separated_along(Vec3::Unit(k), t, half)) {
            return false;
        }
    }
    if (separated_along((t.b - t.a).cross(t.c - t.a), t, half)) {
        return false;
    }
    for (const Vec3& edge : {Vec3(t.b - t.a), Vec3(t.c - t.b), Vec3(t.a - t.c)}) {
        for (int k = 0; k < 3; ++k) {
            if (separated_along(Vec3::Unit(k).cross(edge), t, half)) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace campuswalk::collision
