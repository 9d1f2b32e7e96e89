#include "scene/suggest/first_view.h"

#include <algorithm>
#include <array>

#include "collision/geometry/trigonometry.h"
#include "collision/world/cast.h"

namespace campuswalk::scene {

using collision::Vec3;

double first_view(const collision::World& world, const Vec3& foot, const Vec3& target) {
    constexpr std::size_t kDirections = 36;
    constexpr double kStep = 0.17453292519943295;  // ten degrees
    constexpr double kEye = 1.6;                   // metres above the feet
    constexpr double kMaxSight = 15.0;             // metres
    constexpr double kTargetWeight = 10.0;         // metres
    const Vec3 eye = foot + kEye * Vec3::UnitY();
    std::array<Vec3, kDirections> ahead;
    std::array<double, kDirections> free{};
    for (std::size_t d = 0; d < kDirections; ++d) {
        const collision::SinCos turn = collision::sin_cos(static_cast<double>(d) * kStep);
        ahead[d] = Vec3(-turn.sin, 0.0, -turn.cos);
        const collision::Ray ray{eye, eye + kMaxSight * ahead[d]};
        const auto hit = collision::cast(world, {}, ray, collision::Detection::solid);
        free[d] = hit ? hit->fraction * kMaxSight : kMaxSight;
    }
    Vec3 towards_target = target - foot;
    towards_target.y() = 0.0;
    towards_target = towards_target.isZero(1e-9) ? Vec3::Zero() : Vec3(towards_target.normalized());
    std::size_t best = 0;
    double best_score = -1e300;
    for (std::size_t d = 0; d < kDirections; ++d) {
        const double left = free[(d + 1) % kDirections];
        const double right = free[(d + kDirections - 1) % kDirections];
        const double score = std::min({free[d], left, right}) + kTargetWeight * ahead[d].dot(towards_target);
        if (score > best_score) {
            best_score = score;
            best = d;
        }
    }
    return collision::wrapped_angle(static_cast<double>(best) * kStep);
}

}  // namespace campuswalk::scene
