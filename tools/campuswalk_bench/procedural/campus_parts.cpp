#include "tools/campuswalk_bench/procedural/campus_parts.h"

#include <algorithm>

#include "collision/geometry/trigonometry.h"

namespace campuswalk::tools::bench {

using collision::Pose;
using collision::Vec3;

namespace {

constexpr double kWindow = 3.0;  ///< metres of wall per window
constexpr int kLeaves = 85;      ///< per tree

}  // namespace

Pose pose_with_yaw(const Vec3& at, double yaw) {
    const auto [sin, cos] = collision::sin_cos(yaw);
    Pose X;
    X.rotation << cos, 0.0, sin, 0.0, 1.0, 0.0, -sin, 0.0, cos;
    X.translation = at;
    return X;
}

double rolling_ground(double x, double z) {
    return 3.0 * collision::sin_cos(x / 40.0).sin * collision::sin_cos(z / 55.0).cos +
           1.2 * collision::sin_cos(x / 17.0 + z / 23.0).sin;
}

void add_window_wall(scene::MeshParts& parts, const Pose& X_campus_wall, double half, int storeys) {
    constexpr double kFrame = 0.6;
    constexpr double kRecess = 0.25;
    const auto quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        parts.add_quad(X_campus_wall * a, X_campus_wall * b, X_campus_wall * c, X_campus_wall * d);
    };
    const int bays = std::max(1, static_cast<int>(2.0 * half / kWindow));
    const double wide = 2.0 * half / bays;
    for (int storey = 0; storey < storeys; ++storey) {
        for (int bay = 0; bay < bays; ++bay) {
            const double x = -half + wide * bay;
            const double y = kStorey * storey;
            const Vec3 outer[4] = {
                {x, y, 0}, {x + wide, y, 0}, {x + wide, y + kStorey, 0}, {x, y + kStorey, 0}};
            const Vec3 inner[4] = {{x + kFrame, y + kFrame, 0},
                                   {x + wide - kFrame, y + kFrame, 0},
                                   {x + wide - kFrame, y + kStorey - kFrame, 0},
                                   {x + kFrame, y + kStorey - kFrame, 0}};
            const Vec3 back(0.0, 0.0, -kRecess);
            for (std::size_t i = 0; i < 4; ++i) {
                const std::size_t next = (i + 1) % 4;
                quad(outer[i], outer[next], inner[next], inner[i]);
                quad(inner[i], inner[next], inner[next] + back, inner[i] + back);
            }
            quad(inner[0] + back, inner[1] + back, inner[2] + back, inner[3] + back);
        }
    }
}

void add_tree(scene::MeshParts& parts, const Vec3& foot, SplitMix& random) {
    const double height = random.between(4.0, 9.0);
    const double radius = random.between(1.2, 2.5);
    const Pose X = pose_with_yaw(foot, random.between(0.0, 6.0));
    parts.add_prism(X, {0.0, -0.5, 0.0}, 0.22, height, 6);
    const Vec3 middle = foot + Vec3(0.0, height, 0.0);
    parts.add_ball(middle, {radius, 1.2 * radius, radius}, 10, 7, [&] { return random.between(0.8, 1.1); });
    for (int i = 0; i < kLeaves; ++i) {
        const Vec3 out = random.direction();
        const Vec3 stem = middle + radius * random.between(0.7, 1.2) * out;
        const Vec3 along = 0.3 * random.direction();
        const Vec3 across = 0.15 * random.direction();
        parts.add_quad(stem, stem + along + across, stem + 2.0 * along, stem + along - across);
    }
}

void add_bench(scene::MeshParts& parts, const Pose& X) {
    parts.add_box(X, {0.0, 0.42, 0.0}, {0.9, 0.04, 0.25});
    parts.add_box(X, {0.0, 0.75, -0.22}, {0.9, 0.2, 0.03});
    parts.add_box(X, {0.0, 0.1, 0.0}, {0.7, 0.3, 0.15});
}

void add_lamp(scene::MeshParts& parts, const Pose& X) {
    parts.add_prism(X, {0.0, -0.2, 0.0}, 0.07, 4.2, 6);
    parts.add_box(X, {0.0, 4.1, 0.35}, {0.12, 0.06, 0.45});
}

}  // namespace campuswalk::tools::bench
