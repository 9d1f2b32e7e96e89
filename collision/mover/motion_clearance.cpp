#include "collision/mover/motion_clearance.h"

#include <algorithm>

#include "collision/mover/upright_distance.h"

namespace campuswalk::collision {

namespace {

/// What planes have to show: less than sweeps keep, because a body that stopped where a sweep ended moves
/// along there. Far more than rounding.
constexpr double kSure = 0.8 * kHard;
/// What is kept from earlier has to show more than any other test asks for.
constexpr double kKnown = 0.9 * kRest;

bool apart(const Separation& s, const Vec3& from, const Vec3& to, double distance) {
    return s.bound(from) >= distance && s.bound(to) >= distance;
}

}  // namespace

bool MotionClearance::cleared(ContactCache::Index i, const Vec3& from, const Vec3& to) const {
    if (around_.known_apart(i, from, to, settings_.radius + kKnown)) {
        return true;
    }
    const double keep = settings_.radius + kSure;
    return apart(around_.separation(i, from), from, to, keep) ||
           apart(around_.separation(i, to), from, to, keep);
}

bool MotionClearance::blocked(ContactCache::Index i, const Vec3& from, const Vec3& to) const {
    return sweep_upright(settings_.core(from), settings_.radius + kHard, to - from, around_.piece(i).obstacle)
        .has_value();
}

bool MotionClearance::is_free(const Vec3& from, const Vec3& to) const {
    const auto near = around_.near();
    return std::all_of(near.begin(), near.end(),
                       [&](ContactCache::Index i) { return cleared(i, from, to) || !blocked(i, from, to); });
}

bool MotionClearance::is_free_over(const Vec3& from, const Vec3& to) const {
    const double x = to.x() - from.x();
    const double z = to.z() - from.z();
    const double over = std::max(from.y(), to.y()) + (x * x + z * z) / (8.0 * settings_.radius) + kHard;
    const Vec3 above_from(from.x(), over, from.z());
    const Vec3 above_to(to.x(), over, to.z());
    const auto near = around_.near();
    return std::all_of(near.begin(), near.end(), [&](ContactCache::Index i) {
        const auto known = [&](const Vec3& a, const Vec3& b) {
            return around_.known_apart(i, a, b, settings_.radius + kSure);
        };
        const auto clear = [&](const Vec3& a, const Vec3& b) { return known(a, b) || !blocked(i, a, b); };
        if (known(from, above_from) && known(above_from, above_to) && known(above_to, to)) {
            return true;
        }
        around_.separation(i, from);
        around_.separation(i, to);
        return clear(from, above_from) && clear(above_from, above_to) && clear(above_to, to);
    });
}

Vec3 MotionClearance::free_part(const Vec3& foot, const Vec3& move, double radius) const {
    double fraction = 1.0;
    for (const ContactCache::Index i : around_.near()) {
        if (around_.known_apart(i, foot, foot + move, radius + kHard)) {
            continue;
        }
        if (const auto f = sweep_upright(settings_.core(foot), radius, move, around_.piece(i).obstacle)) {
            fraction = std::min(fraction, *f);
        }
    }
    return fraction * move;
}

bool MotionClearance::meets(ContactCache::Index i, const Vec3& foot, const Vec3& move) const {
    return !apart(around_.separation(i, foot), foot, foot + move, settings_.radius + kRest) &&
           sweep_upright(settings_.core(foot), settings_.radius + kRest, move, around_.piece(i).obstacle);
}

}  // namespace campuswalk::collision
