#include "scene/model/node_frame.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace campuswalk::scene {
namespace {

using collision::Mat3;
using collision::Vec3;

/// The component of `v` perpendicular to the unit vector `along`, normalized; zero if they are parallel.
Vec3 unit_perpendicular(const Vec3& v, const Vec3& along) {
    constexpr double kParallel = 1e-9;  // sine
    const double length = v.norm();
    const Vec3 rest = v - along * along.dot(v);
    const double remaining = rest.norm();
    return remaining > kParallel * length ? Vec3(rest / remaining) : Vec3::Zero();
}

Vec3 any_perpendicular(const Vec3& unit) {
    int least = 0;
    for (int i = 1; i < 3; ++i) {
        if (std::abs(unit[i]) < std::abs(unit[least])) {
            least = i;
        }
    }
    return unit_perpendicular(Vec3::Unit(least), unit);
}

struct SineCosine {
    double sine = 0.0;
    double cosine = 1.0;
};

/// Taylor series, exact to the last bits for |x| <= pi/4.
SineCosine series(double x) {
    constexpr int kTerms = 10;
    double sine_term = x;
    double cosine_term = 1.0;
    SineCosine sum{x, 1.0};
    for (int n = 1; n < kTerms; ++n) {
        cosine_term *= -x * x / ((2.0 * n - 1.0) * (2.0 * n));
        sine_term *= -x * x / ((2.0 * n) * (2.0 * n + 1.0));
        sum.cosine += cosine_term;
        sum.sine += sine_term;
    }
    return sum;
}

SineCosine sine_cosine(double angle) {
    constexpr double kQuarterTurn = std::numbers::pi / 2.0;
    const double turns = angle / kQuarterTurn;
    const auto quarters = static_cast<long long>(turns < 0.0 ? turns - 0.5 : turns + 0.5);
    const SineCosine rest = series(angle - static_cast<double>(quarters) * kQuarterTurn);
    switch (((quarters % 4) + 4) % 4) {
        case 0:
            return rest;
        case 1:
            return {rest.cosine, -rest.sine};
        case 2:
            return {-rest.sine, -rest.cosine};
        default:
            return {-rest.cosine, rest.sine};
    }
}

}  // namespace

collision::Pose upright_frame(const Eigen::Matrix4d& X_world_node) {
    collision::Pose frame;
    frame.translation = X_world_node.topRightCorner<3, 1>();
    // The axis nearest to up; ties prefer y, then z.
    const Mat3 linear = X_world_node.topLeftCorner<3, 3>();
    int up = 1;
    double best = -1.0;
    for (const int axis : {1, 2, 0}) {
        const double length = linear.col(axis).norm();
        const double nearness = length > 0.0 ? std::abs(linear(1, axis)) / length : -1.0;
        if (nearness > best + 1e-9) {
            best = nearness;
            up = axis;
        }
    }
    if (best < 0.0) {
        return frame;
    }
    const Vec3 y = linear.col(up).normalized() * (linear(1, up) < 0.0 ? -1.0 : 1.0);
    Vec3 x = unit_perpendicular(linear.col(up == 0 ? 1 : 0), y);
    if (x.isZero()) {
        x = any_perpendicular(y);
    }
    frame.rotation << x, y, x.cross(y);
    return frame;
}

collision::Mat3 rotation_about_y(double yaw) {
    const SineCosine t = sine_cosine(yaw);
    Mat3 rotation;
    rotation << t.cosine, 0, t.sine,  //
        0, 1, 0,                      //
        -t.sine, 0, t.cosine;
    return rotation;
}

collision::Mat3 rotation_xyz(const Vec3& angles) {
    const SineCosine x = sine_cosine(angles.x());
    const SineCosine z = sine_cosine(angles.z());
    Mat3 about_x;
    about_x << 1, 0, 0,        //
        0, x.cosine, -x.sine,  //
        0, x.sine, x.cosine;
    Mat3 about_z;
    about_z << z.cosine, -z.sine, 0,  //
        z.sine, z.cosine, 0,          //
        0, 0, 1;
    return about_x * rotation_about_y(angles.y()) * about_z;
}

collision::Mat3 rotation_with_x_along(const collision::Vec3& axis) {
    const Vec3 x = axis.normalized();
    const Vec3 y = any_perpendicular(x);
    Mat3 rotation;
    rotation << x, y, x.cross(y);
    return rotation;
}

}  // namespace campuswalk::scene
