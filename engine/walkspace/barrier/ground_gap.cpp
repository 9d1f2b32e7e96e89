#include "engine/walkspace/barrier/ground_gap.h"

#include <cmath>
#include <limits>

#include "collision/world/cast.h"

namespace campuswalk::engine {

using collision::Ray;
using collision::Vec3;

namespace {

/// Ground that is so much higher or lower at one end than at the other is a roof, or below one, metres.
constexpr double kSameLevel = 1.0;
/// Where there might be ground between is looked for this far above and below the line, metres.
constexpr double kAboveLine = 0.9;
constexpr double kBelowLine = 0.9;
/// How far apart, and how near to both ends, metres.
constexpr double kEvery = 0.25;
constexpr double kEnds = 0.5;

struct Pair {
    const GroundState* from = nullptr;
    const UnreachedSpot* to = nullptr;
    double apart = std::numeric_limits<double>::max();
};

Pair nearest_pair(const Island& island, const std::vector<GroundState>& reached) {
    Pair nearest;
    for (const GroundState& from : reached) {
        for (const UnreachedSpot& spot : island.spots) {
            const double apart = collision::horizontal_norm(spot.at.foot - from.foot);
            if (apart < nearest.apart && std::abs(spot.at.foot.y() - from.foot.y()) <= kSameLevel) {
                nearest = {&from, &spot, apart};
            }
        }
    }
    return nearest;
}

/// Nothing in the way of a look from one to the other, and no ground below it but at its ends.
bool is_void_between(const collision::World& world, const ExploreSettings& settings, const Vec3& from,
                     const Vec3& to) {
    const auto is_hit = [&](const Ray& ray) {
        return collision::cast(world, settings.solids, ray, collision::Detection::solid).has_value();
    };
    const Vec3 eye(0, 0.5 * settings.strides.body.height, 0);
    if (is_hit({from + eye, to + eye})) {
        return false;
    }
    const auto is_ground_at = [&](double share) {
        const Vec3 p = from + share * (to - from);
        return is_hit({p + Vec3(0, kAboveLine, 0), p - Vec3(0, kBelowLine, 0)});
    };
    const double length = collision::horizontal_norm(to - from);
    if (is_ground_at(0.5)) {
        return false;
    }
    for (int i = 0; kEnds + i * kEvery < length - kEnds; ++i) {
        if (is_ground_at((kEnds + i * kEvery) / length)) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::optional<Barrier> find_gap(const collision::World& world, const ExploreSettings& settings,
                                const Island& island, const std::vector<GroundState>& reached) {
    const Pair pair = nearest_pair(island, reached);
    if (pair.to == nullptr || !is_void_between(world, settings, pair.from->foot, pair.to->at.foot)) {
        return std::nullopt;
    }
    Barrier gap;
    gap.kind = BarrierKind::gap;
    gap.measured = pair.apart;
    gap.at = pair.to->at.foot;
    gap.from = pair.from->foot;
    gap.object = pair.to->object;
    gap.triangle = pair.to->triangle;
    return gap;
}

}  // namespace campuswalk::engine
