#include "collision/mover/motion_clearance.h"

#include <algorithm>
#include <cmath>

#include "collision/mover/upright_distance.h"

namespace campuswalk::collision {

namespace {

/// The gap that planes have to prove: smaller than that of sweeps, because a body that stopped where a sweep
/// ended moves on from there. Far larger than rounding.
constexpr double kPlaneGap = 0.8 * kSweepGap;
/// The gap that cached planes have to prove: larger than that of any other test.
constexpr double kCachedPlaneGap = 0.9 * kRestGap;

bool apart(const Separation& s, const Vec3& from, const Vec3& to, double distance) {
    return s.bound(from) >= distance && s.bound(to) >= distance;
}

bool is_cleared(MoveContext& context, ContactCache::Index i, const Vec3& from, const Vec3& to) {
    const double radius = context.body.radius;
    if (context.contacts.known_apart(i, from, to, radius + kCachedPlaneGap)) {
        return true;
    }
    const double clear = radius + kPlaneGap;
    return apart(context.contacts.measure(i, from), from, to, clear) ||
           apart(context.contacts.measure(i, to), from, to, clear);
}

bool is_blocked(const MoveContext& context, ContactCache::Index i, const Vec3& from, const Vec3& to) {
    return sweep_upright(context.body.core(from), context.body.radius + kSweepGap, to - from,
                         context.contacts.piece(i).obstacle)
        .has_value();
}

}  // namespace

bool is_free(MoveContext& context, const Vec3& from, const Vec3& to) {
    return std::ranges::all_of(context.near, [&](ContactCache::Index i) {
        return is_cleared(context, i, from, to) || !is_blocked(context, i, from, to);
    });
}

bool is_free_over(MoveContext& context, const Vec3& from, const Vec3& to) {
    const double radius = context.body.radius;
    const double x = to.x() - from.x();
    const double z = to.z() - from.z();
    const double over = std::max(from.y(), to.y()) + (x * x + z * z) / (8.0 * radius) + kSweepGap;
    const Vec3 above_from(from.x(), over, from.z());
    const Vec3 above_to(to.x(), over, to.z());
    return std::ranges::all_of(context.near, [&](ContactCache::Index i) {
        const auto known = [&](const Vec3& a, const Vec3& b) {
            return context.contacts.known_apart(i, a, b, radius + kPlaneGap);
        };
        const auto clear = [&](const Vec3& a, const Vec3& b) {
            return known(a, b) || !is_blocked(context, i, a, b);
        };
        if (known(from, above_from) && known(above_from, above_to) && known(above_to, to)) {
            return true;
        }
        context.contacts.measure(i, from);
        context.contacts.measure(i, to);
        return clear(from, above_from) && clear(above_from, above_to) && clear(above_to, to);
    });
}

bool is_free_around_edge(MoveContext& context, const Vec3& from, const Vec3& to) {
    const Vec3 chord = to - from;
    const double across = horizontal_norm(chord);
    const double square = chord.squaredNorm();
    if (!(across > 0.0) || square > context.body.radius * context.body.radius) {
        return false;
    }
    // The tangents meet so far above the chord's middle, along the normal of the chord.
    const double above = square / (4.0 * context.body.radius) + kSweepGap;
    const Vec3 up =
        Vec3(-chord.x() * chord.y() / across, across, -chord.z() * chord.y() / across) / std::sqrt(square);
    const Vec3 apex = 0.5 * (from + to) + above * up;
    return is_free(context, from, apex) && is_free(context, apex, to);
}

Vec3 free_part(const MoveContext& context, const Vec3& foot, const Vec3& move, double radius) {
    double fraction = 1.0;
    for (const ContactCache::Index i : context.near) {
        if (context.contacts.known_apart(i, foot, foot + move, radius + kSweepGap)) {
            continue;
        }
        if (const auto f =
                sweep_upright(context.body.core(foot), radius, move, context.contacts.piece(i).obstacle)) {
            fraction = std::min(fraction, *f);
        }
    }
    return fraction * move;
}

bool comes_near(MoveContext& context, ContactCache::Index i, const Vec3& foot, const Vec3& move) {
    const double clear = context.body.radius + kRestGap;
    return !apart(context.contacts.measure(i, foot), foot, foot + move, clear) &&
           sweep_upright(context.body.core(foot), clear, move, context.contacts.piece(i).obstacle);
}

}  // namespace campuswalk::collision
