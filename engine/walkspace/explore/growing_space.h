#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/explore/frontier.h"
#include "engine/walkspace/explore/goal_policy.h"
#include "engine/walkspace/explore/known_cells.h"
#include "engine/walkspace/explore/stride_worker.h"
#include "engine/walkspace/space/walk_space.h"

namespace campuswalk::engine {

/// A walk space while it is explored, with what is left to do in each of its tiles. Threads may add to tiles
/// while no other changes them or those around them.
class GrowingSpace {
public:
    /// Both must outlive it.
    GrowingSpace(const ExploreSettings& settings, const ExploreGoal& goal);

    WalkSpace space;
    std::vector<Frontier> frontiers;  ///< by tile

    const GoalPolicy& policy() const { return policy_; }
    const KnownCells& known() const { return known_; }

    std::uint32_t tile_for(const GridCell& cell);
    WalkNodeId add_start(const GroundState& at, Strider& strider);
    /// Sets the space's goal if a node of any tile is one.
    void note_goal();
    void note_drop(std::uint32_t tile, const WalkTile::Drop& drop);
    /// Adds the node to which a stride from the tile led, or keeps it for the tile that it is in.
    void arrive(std::uint32_t tile, const Pending& from, const Stride& stride, const StrideEnd& end,
                StrideWorker& worker);
    void add_or_send(std::uint32_t tile, const Arrival& arrival, StrideWorker& worker);
    /// Adds a node to which a stride from another tile led.
    void receive(std::uint32_t tile, const Arrival& arrival, StrideWorker& worker);

private:
    bool is_out(const collision::Vec3& foot) const;
    void add_arrival(std::uint32_t tile, WalkNode node, const Arrival& arrival, StrideWorker& worker);
    /// None if the tile is full.
    std::optional<std::uint16_t> add_node(std::uint32_t tile, const WalkNode& node, const GroundState& at,
                                          std::uint32_t ticks, std::uint8_t since_keyframe);

    const ExploreSettings& settings_;
    const GoalPolicy policy_;
    const KnownCells known_{settings_, policy_, space, frontiers};
};

}  // namespace campuswalk::engine
