#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/explore/frontier.h"
#include "engine/walkspace/explore/goal_policy.h"
#include "engine/walkspace/space/walk_space.h"

namespace campuswalk::engine {

/// What an exploration needn't stride to again. Threads may ask about tiles while no other changes them or
/// those around them, or what these have sent.
class KnownCells {
public:
    /// `frontiers`: by tile. All of them must outlive it, where they are.
    KnownCells(const ExploreSettings& settings, const GoalPolicy& policy, const WalkSpace& space,
               const std::vector<Frontier>& frontiers);

    /// Whether the cell has a node for a body at this height; it is in the tile or beside it. What was
    /// reached there in this round counts too, but for a path to a point: a later arrival may be the better
    /// one.
    bool has(const GridCell& cell, double y, bool hangs, std::uint32_t tile) const;
    /// Whether the ground goes on ahead as it comes from behind, up or down a slope, and has a node there.
    bool has_ahead(const GridCell& ahead, const GridCell& behind, double y, std::uint32_t tile) const;
    /// Whether all cells within so many metres have a node for the body.
    bool has_all_near(const collision::Vec3& foot, double metres, bool hangs, std::uint32_t tile) const;

    /// Whether the ground goes on from there in one of grid_directions(), level or up and down slopes, for so
    /// many metres, beside the straight line as well: its lowest height. None farther than a tile is long.
    std::optional<double> ground_ahead(const collision::Vec3& foot, std::uint8_t direction, double metres,
                                       std::uint32_t tile) const;

private:
    std::optional<double> level_in(const GridCell& cell, double y, double tolerance,
                                   std::uint32_t tile) const;

    const ExploreSettings& settings_;
    const GoalPolicy& policy_;
    const WalkSpace& space_;
    const std::vector<Frontier>& frontiers_;
    double most_rise_;  ///< of walkable ground, to the next cell, metres
};

}  // namespace campuswalk::engine
