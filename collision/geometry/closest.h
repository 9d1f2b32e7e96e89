#pragma once

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

/// The part of a shape that a closest point lies on. Flat parts of neighbouring shapes may be flush, with no
/// real edge between them; `face` means that the normal can be trusted.
enum class Feature { face, edge };

/// The closest points of a segment and a shape, world coordinates, metres.
struct Closest {
    Vec3 on_segment = Vec3::Zero();
    Vec3 on_shape = Vec3::Zero();
    double distance = 0.0;  ///< 0 if they share a point; convex solids are filled, triangles are surfaces
    Feature feature = Feature::face;
};

// Ericson, Real-Time Collision Detection, 5.1.5 (triangle) and 5.1.9 (segments).

Vec3 closest_on_segment(const Segment& segment, const Vec3& point);
Vec3 closest_on_triangle(const Triangle& triangle, const Vec3& point, Feature& feature);
Closest closest(const Segment& s, const Segment& t);
Closest closest(const Segment& segment, const Triangle& triangle);

// Convex solids at a pose.

Closest closest(const Segment& segment, const Sphere& sphere, const Pose& X_world_shape);
Closest closest(const Segment& segment, const Capsule& capsule, const Pose& X_world_shape);
Closest closest(const Segment& segment, const Box& box, const Pose& X_world_shape);
Closest closest(const Segment& segment, const Wheel& wheel, const Pose& X_world_shape);

/// The argument in [0, 1] that minimizes the convex function `f`, by golden-section search: 48 steps narrow
/// the interval to 1e-10; the error of the minimum is the square of that.
template <typename Convex>
double minimise_convex(const Convex& f) {
    constexpr double kGolden = 0.6180339887498949;
    double low = 0.0;
    double high = 1.0;
    double left = high - kGolden * (high - low);
    double right = low + kGolden * (high - low);
    double f_left = f(left);
    double f_right = f(right);
    for (int i = 0; i < 48; ++i) {
        if (f_left <= f_right) {
            high = right;
            right = left;
            f_right = f_left;
            left = high - kGolden * (high - low);
            f_left = f(left);
        } else {
            low = left;
            left = right;
            f_left = f_right;
            right = low + kGolden * (high - low);
            f_right = f(right);
        }
    }
    const double middle = 0.5 * (low + high);
    double best = middle;
    double f_best = f(middle);
    for (const double end : {0.0, 1.0}) {
        if (const double f_end = f(end); f_end <= f_best) {
            best = end;
            f_best = f_end;
        }
    }
    return best;
}

}  // namespace campuswalk::collision
