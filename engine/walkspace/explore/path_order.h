#pragma once

#include <cstdint>

#include "engine/walkspace/explore/explore.h"

namespace campuswalk::engine {

/// In which order the exploration takes nodes on the way to a point: by the ticks to them and those from
/// there on, where falls and tight places count for more than they take. Without a point, by the ticks to
/// them alone.
class PathOrder {
public:
    /// `settings` must outlive it.
    explicit PathOrder(const ExploreSettings& settings);

    bool has_goal() const { return settings_.towards || settings_.is_goal; }
    /// So many ticks after its strides along the axes, a node takes the diagonal ones.
    std::uint32_t diagonals_later() const { return diagonals_later_; }
    /// And so many after these, it jumps over ground where nothing is in the way.
    std::uint32_t jumps_later() const { return jumps_later_; }

    std::uint32_t ticks_in(double seconds) const;
    /// Straight on, as the strides go: along the axes and diagonals.
    std::uint32_t ticks_to_goal(const collision::Vec3& foot) const;
    /// What a stride counts for besides its ticks.
    std::uint32_t ticks_for_detour(const StrideEnd& end) const;

private:
    const ExploreSettings& settings_;
    std::uint32_t diagonals_later_ = 0;
    std::uint32_t jumps_later_ = 0;
};

}  // namespace campuswalk::engine
