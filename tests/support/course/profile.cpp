#include "tests/support/course/profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/angles.h"

namespace campuswalk::support {

namespace {

constexpr double kLevel = 8.0;

/// Height of a ball over x = 0 that touches the piece from above; far below if it can't.
double rolled_over_piece(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double radius) {
    const auto touching = [&](double x, double y) { return y + std::sqrt(radius * radius - x * x) - radius; };
    if (b.x() < -radius || a.x() > radius) {
        return -1e300;
    }
    if (b.x() == a.x()) {
        return touching(a.x(), std::max(a.y(), b.y()));
    }
    // The height is a concave function of the touched point, so its maximum is at the tangent point or at the
    // end of the piece nearest to it.
    const double slope = (b.y() - a.y()) / (b.x() - a.x());
    const double tangent = radius * slope / std::sqrt(1.0 + slope * slope);
    const double x = std::clamp(tangent, std::max(a.x(), -radius), std::min(b.x(), radius));
    return touching(x, a.y() + slope * (x - a.x()));
}

}  // namespace

Profile flight(double x, double riser, double tread, int steps) {
    Profile profile = {{x - kLevel, 0.0}};
    for (int i = 0; i < steps; ++i) {
        const double edge = x + i * tread;
        profile.emplace_back(edge, i * riser);
        profile.emplace_back(edge, (i + 1) * riser);
    }
    profile.emplace_back(x + (steps - 1) * tread + kLevel, steps * riser);
    return profile;
}

Profile ramp(double x, double degrees, double run) {
    const double high = run * std::tan(radians(degrees));
    return {{x - kLevel, 0.0}, {x, 0.0}, {x + run, high}, {x + run + kLevel, high}};
}

Profile waves(double length, double height, int count, int pieces) {
    Profile profile = {{-kLevel, 0.0}};
    for (int i = 0; i <= count * pieces; ++i) {
        const double turns = i / static_cast<double>(pieces);
        profile.emplace_back(turns * length, 0.5 * height * (1.0 - std::cos(2.0 * std::numbers::pi * turns)));
    }
    profile.emplace_back(count * length + kLevel, 0.0);
    return profile;
}

void add_profile(TriangleMesh& mesh, const Profile& profile, double half_width) {
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const auto at = [&](std::size_t k, double z) { return Vector3d(profile[k].x(), profile[k].y(), z); };
        add_quad(mesh, at(i - 1, half_width), at(i, half_width), at(i, -half_width), at(i - 1, -half_width));
    }
}

double rolled_height(const Profile& profile, double x, double radius) {
    const Eigen::Vector2d here(x, 0.0);
    double highest = -1e300;
    for (std::size_t i = 1; i < profile.size(); ++i) {
        highest = std::max(highest, rolled_over_piece(profile[i - 1] - here, profile[i] - here, radius));
    }
    return highest;
}

}  // namespace campuswalk::support
