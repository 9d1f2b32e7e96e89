#pragma once

#include <vector>

#include "collision/mover/contact_cache.h"

namespace campuswalk::collision {

/// Straight ways of the body past what is near, which must have been surveyed for all of them. A plane that
/// has the piece on one side and the body on the other at both ends of a way clears it; only what no plane
/// at hand clears is swept.
class MotionClearance {
public:
    MotionClearance(ContactCache& around, const MoverSettings& settings)
        : around_(around), settings_(settings) {}

    /// From one place of the foot to another.
    bool is_free(const Vec3& from, const Vec3& to) const;
    /// Up, across and down: what a round body rolls over is higher between two places than at both.
    bool is_free_over(const Vec3& from, const Vec3& to) const;
    /// The part of `move` that keeps `radius` about the core free.
    Vec3 free_part(const Vec3& foot, const Vec3& move, double radius) const;
    /// Whether the body comes nearer than kRest to one piece, if it moves.
    bool meets(ContactCache::Index i, const Vec3& foot, const Vec3& move) const;

private:
    bool cleared(ContactCache::Index i, const Vec3& from, const Vec3& to) const;
    bool blocked(ContactCache::Index i, const Vec3& from, const Vec3& to) const;

    ContactCache& around_;
    const MoverSettings& settings_;
};

}  // namespace campuswalk::collision
