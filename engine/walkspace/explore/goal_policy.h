#pragma once

#include <cstdint>
#include <variant>

#include "engine/walkspace/explore/explore.h"

namespace campuswalk::engine {

/// How the goal directs the exploration. On the way to a point, nodes are taken by the ticks to them and
/// those from there on, where falls and tight places count for more than they take; else by the ticks to them
/// alone.
class GoalPolicy {
public:
    /// Both must outlive it.
    GoalPolicy(const StrideSettings& strides, const ExploreGoal& goal);

    bool has_goal() const { return !std::holds_alternative<Everywhere>(goal_); }
    bool leads_to_point() const { return point() != nullptr; }
    /// Whether a node of this cell, at which the body is in this state, is what is looked for.
    bool is_goal(const GridCell& cell, const GroundState& at) const;
    /// A node takes its diagonal strides this many ticks after those along the axes.
    std::uint32_t diagonals_later() const { return diagonals_later_; }
    /// A node jumps over ground where nothing is in the way this many ticks after its strides.
    std::uint32_t jumps_later() const { return jumps_later_; }

    /// Returns the ticks that strides along the axes and diagonals take to the goal with nothing in the way;
    /// 0 without a point.
    std::uint32_t ticks_to_goal(const collision::Vec3& foot) const;
    /// What a stride counts for besides its ticks.
    std::uint32_t ticks_for_detour(const StrideEnd& end) const;

private:
    const TowardsPoint* point() const { return std::get_if<TowardsPoint>(&goal_); }
    std::uint32_t ticks_in(double seconds) const;

    const StrideSettings& strides_;
    const ExploreGoal& goal_;
    std::uint32_t diagonals_later_ = 0;
    std::uint32_t jumps_later_ = 0;
};

}  // namespace campuswalk::engine
