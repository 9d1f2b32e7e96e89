#include "engine/walkspace/explore/goal_policy.h"

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

GoalPolicy::GoalPolicy(const StrideSettings& strides, const ExploreGoal& goal)
    : strides_(strides), goal_(goal) {
    if (!has_goal()) {  // on a path to a goal they are as good
        diagonals_later_ = ticks_in(kDiagonalsLater / strides.walk_speed);
        jumps_later_ = ticks_in(kJumpsLater * jump_length(strides) / strides.walk_speed);
    }
}

bool GoalPolicy::is_goal(const GridCell& cell, const GroundState& at) const {
    if (const TowardsPoint* towards = point()) {
        return towards->is_goal(at);
    }
    const auto* until = std::get_if<UntilCell>(&goal_);
    return until != nullptr && until->is_goal(cell, at.foot.y());
}

std::uint32_t GoalPolicy::ticks_in(double seconds) const {
    constexpr double kMost = 1e9;
    return static_cast<std::uint32_t>(std::min(kMost, seconds / strides_.seconds));
}

std::uint32_t GoalPolicy::ticks_to_goal(const Vec3& foot) const {
    const TowardsPoint* towards = point();
    if (towards == nullptr) {
        return 0;
    }
    const Vec3 apart = (towards->point - foot).cwiseAbs();
    const double less = std::min(apart.x(), apart.z());
    const double more = std::max(apart.x(), apart.z());
    return ticks_in((more - less + less / kDiagonal) / strides_.walk_speed);
}

std::uint32_t GoalPolicy::ticks_for_detour(const StrideEnd& end) const {
    const TowardsPoint* towards = point();
    if (towards == nullptr) {
        return 0;
    }
    const double fall = end.left_ground ? end.edge.y() - end.at.foot.y() - kHarmlessFall : 0.0;
    const bool tight = towards->is_tight && towards->is_tight(end.at.foot);
    return (fall > 0.0 ? ticks_in(fall * kSecondsRoundAFall) : 0U) +
           (tight ? (kTightFactor - 1U) * static_cast<std::uint32_t>(end.ticks) : 0U);
}

}  // namespace campuswalk::engine
