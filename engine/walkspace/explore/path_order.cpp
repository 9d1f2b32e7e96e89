#include "engine/walkspace/explore/path_order.h"

#include <algorithm>

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// Nodes take their diagonal strides this much later than the others, metres of walking: somewhat more than
/// the 0.1 m that they are longer, so that nearly all cells are reached by the shorter strides.
constexpr double kDiagonalsLater = 0.19;
/// Over ground where nothing is in the way they jump so much later, in lengths of a jump, walked: then the
/// ground ahead is mostly known.
constexpr double kJumpsLater = 2.0;

}  // namespace

PathOrder::PathOrder(const ExploreSettings& settings) : settings_(settings) {
    if (!has_goal()) {  // on a path to a goal they are as good
        const StrideSettings& strides = settings.strides;
        diagonals_later_ = ticks_in(kDiagonalsLater / strides.walk_speed);
        jumps_later_ = ticks_in(kJumpsLater * jump_length(strides) / strides.walk_speed);
    }
}

std::uint32_t PathOrder::ticks_in(double seconds) const {
    constexpr double kMost = 1e9;
    return static_cast<std::uint32_t>(std::min(kMost, seconds / settings_.strides.seconds));
}

std::uint32_t PathOrder::ticks_to_goal(const Vec3& foot) const {
    if (!settings_.towards) {
        return 0;
    }
    const Vec3 apart = (*settings_.towards - foot).cwiseAbs();
    const double less = std::min(apart.x(), apart.z());
    const double more = std::max(apart.x(), apart.z());
    return ticks_in((more - less + less / kDiagonal) / settings_.strides.walk_speed);
}

std::uint32_t PathOrder::ticks_for_detour(const StrideEnd& end) const {
    if (!settings_.towards) {
        return 0;
    }
    const double fall = end.left_ground ? end.edge.y() - end.at.foot.y() - kHarmlessFall : 0.0;
    const bool tight = settings_.is_tight && settings_.is_tight(end.at.foot);
    return (fall > 0.0 ? ticks_in(fall * kSecondsRoundAFall) : 0U) +
           (tight ? (kTightFactor - 1U) * static_cast<std::uint32_t>(end.ticks) : 0U);
}

}  // namespace campuswalk::engine
