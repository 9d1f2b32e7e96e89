#include "collision/mover/sphere_rest.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace campuswalk::collision {

namespace {

/// Twice the signed area of the triangle (a, b, (x, z)) seen from above.
double turn_of(const Vec3& a, const Vec3& b, double x, double z) {
    return (b.x() - a.x()) * (z - a.z()) - (b.z() - a.z()) * (x - a.x());
}

bool over(const Triangle& t, double x, double z) {
    const std::array turns{turn_of(t.a, t.b, x, z), turn_of(t.b, t.c, x, z), turn_of(t.c, t.a, x, z)};
    return (turns[0] >= 0.0 && turns[1] >= 0.0 && turns[2] >= 0.0) ||
           (turns[0] <= 0.0 && turns[1] <= 0.0 && turns[2] <= 0.0);
}

/// The highest of the rests offered, of those that are useful.
struct Highest {
    double useful;
    std::optional<SphereRest> best = std::nullopt;

    /// Whether a sphere comes to rest too low on what is no higher than `top`, if the squared height of its
    /// centre over where it touches, times `scale`, is at most `left`.
    bool is_below(double top, double scale, double left) const {
        constexpr double kRounding = 1e-9;
        const double above = useful - top - kRounding;
        return above > 0.0 && above * above * scale > left;
    }

    void offer(double height, const Vec3& on) {
        if (!best || height > best->height) {
            best = SphereRest{height, on};
        }
    }
};

void rest_on_vertex(const Vec3& vertex, double x, double z, double radius, Highest& highest) {
    const double dx = x - vertex.x();
    const double dz = z - vertex.z();
    const double left = radius * radius - (dx * dx + dz * dz);
    if (left >= 0.0 && !highest.is_below(vertex.y(), 1.0, left)) {
        highest.offer(vertex.y() + std::sqrt(left), vertex);
    }
}

/// The sphere's centre is as far from the edge's line as its radius: a quadratic in its height over `a`.
void rest_on_edge(const Vec3& a, const Vec3& b, double x, double z, double radius, Highest& highest) {
    constexpr double kUpright = 1e-10;  // squared sine of the angle to the vertical
    const Vec3 e = b - a;
    const double flat2 = e.x() * e.x() + e.z() * e.z();
    const double length2 = flat2 + e.y() * e.y();
    if (flat2 <= kUpright * length2) {
        return;
    }
    const double wx = x - a.x();
    const double wz = z - a.z();
    // The centre's horizontal distance from the edge's line, times the edge's horizontal length.
    const double aside = wx * e.z() - wz * e.x();
    const double left = radius * radius * flat2 - aside * aside;
    if (left < 0.0 || highest.is_below(std::max(a.y(), b.y()), flat2, left)) {
        return;
    }
    const double seen = wx * e.x() + wz * e.z();
    const double up = (seen * e.y() + std::sqrt(left * length2)) / flat2;
    const double along = seen + up * e.y();
    if (along >= 0.0 && along <= length2) {
        highest.offer(a.y() + up, a + (along / length2) * e);
    }
}

}  // namespace

std::optional<SphereRest> sphere_rest(const Triangle& triangle, const Vec3& normal, double x, double z,
                                      double radius, double useful) {
    constexpr double kSteepest = 1e-5;  // an upright face is touched at its upper edge
    if (std::abs(normal.y()) > kSteepest) {
        const Vec3 up = normal.y() > 0.0 ? normal : Vec3(-normal);
        const SphereRest rest = rest_on_face(triangle.a, up, x, z, radius);
        if (over(triangle, rest.on.x(), rest.on.z())) {  // no edge can be touched before the face
            return rest;
        }
    }
    Highest highest{useful};
    rest_on_vertex(triangle.a, x, z, radius, highest);
    rest_on_vertex(triangle.b, x, z, radius, highest);
    rest_on_vertex(triangle.c, x, z, radius, highest);
    rest_on_edge(triangle.a, triangle.b, x, z, radius, highest);
    rest_on_edge(triangle.b, triangle.c, x, z, radius, highest);
    rest_on_edge(triangle.c, triangle.a, x, z, radius, highest);
    return highest.best;
}

}  // namespace campuswalk::collision
