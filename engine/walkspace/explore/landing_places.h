#pragma once

#include <unordered_map>
#include <vector>

#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/space/walk_space.h"

namespace campuswalk::engine {

/// Where a body leaves the ground.
struct FallEdge {
    collision::Vec3 at = collision::Vec3::Zero();  ///< its feet, at the height of what carried it
    Gait gait = Gait::walk;
};

/// Surfaces that aren't reached yet. Where a fall can't end on one, it is of no use to try how it may be
/// steered. Bodies that slide along walls and slopes on their way are allowed for, roughly. Threads may share
/// one.
class LandingPlaces {
public:
    /// Finds those below the edges.
    LandingPlaces(const WorkerWorlds& worlds, const ExploreSettings& settings, const WalkSpace& reached,
                  const std::vector<FallEdge>& edges);

    /// Whether a body that leaves the ground there may land on one, steered as it likes.
    bool has_any_below(const FallEdge& edge) const;

private:
    void add_surfaces(const WorkerWorlds& worlds, const WalkSpace& reached, const collision::Aabb& region);
    void add_round_solids(const collision::World& world, const collision::Aabb& region);
    void add(const collision::Vec3& at);
    bool is_explored_elsewhere(const collision::Vec3& at) const;
    double seconds_to(const FallEdge& edge, double y) const;
    collision::Aabb region_below(const FallEdge& edge) const;
    double reach_after(const FallEdge& edge, double seconds) const;

    const ExploreSettings& settings_;
    double bottom_;
    std::unordered_map<GridCell, std::vector<collision::Vec3>, GridCellHash> blocks_;  ///< of 2 m
    std::vector<collision::Aabb> round_solids_;
};

}  // namespace campuswalk::engine
