#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "collision/geometry/shapes.h"
#include "engine/walkspace/space/walk_tile.h"
#include "engine/walkspace/stride/stride.h"
#include "engine/walkspace/stride/walk_grid.h"

namespace campuswalk::engine {

/// What cut an exploration, or a report of it, short. Places beyond may be reachable.
enum class Bound : std::uint8_t {
    nodes,     ///< the most nodes that are kept
    levels,    ///< more levels above one another than a tile holds
    falls,     ///< a fall that didn't end: see StrideEnd::Kind::falling
    steering,  ///< in falls, only some of the ways to steer were tried
    islands,   ///< more ground that isn't reached than is looked at: none of it is reported
};

/// What they are called in files, in their order.
inline constexpr std::array kBoundNames{"nodes", "levels", "falls", "steering", "islands"};

/// One stride of a chain, and where it ended.
struct ChainLink {
    Stride stride;  ///< meaningless for the first link
    GroundState at;
};

/// From one end of its strides to the next, metres.
double length_of(const std::vector<ChainLink>& chain);

/// All places that a body can reach by walking from its starts: nodes in cells of a grid. Every node has a
/// chain of strides from a start, each of which starts exactly where the one before ended.
class WalkSpace {
public:
    explicit WalkSpace(const WalkGrid& cells) : grid(cells) {}

    WalkGrid grid;
    std::vector<WalkTile> tiles;        ///< in the order in which they were reached
    std::vector<WalkNodeId> starts;     ///< of the given starts that have room and ground, in their order
    std::vector<std::size_t> start_of;  ///< by start: its number among those given
    std::vector<bool> touched;          ///< by object: some stride was seen to touch it
    std::optional<WalkNodeId> goal;     ///< what was looked for, if it was reached: see ExploreGoal
    std::vector<Bound> bounds;          ///< what cut the exploration short, ascending
    std::uint64_t ticks = 0;            ///< simulated, for statistics
    std::uint64_t strides = 0;

    bool is_cut_by(Bound bound) const;
    std::size_t node_count() const;
    /// m² of cells, each level counted; bodies that hang over an edge stand on no ground of their own.
    double area() const;
    /// Of it, where a body that has crouched can't stand up.
    double low_area() const;
    const WalkNode& node(const WalkNodeId& ref) const { return tiles[ref.tile].nodes[ref.node]; }
    GridCell cell_of(const WalkNodeId& ref) const { return tiles[ref.tile].cell_of(node(ref)); }
    /// The middle of the node's cell, at the node's height: the foot is within a cell's half diagonal.
    collision::Vec3 position(const WalkNodeId& ref) const;

    /// The node in this cell nearest to the height, within `tolerance` metres.
    std::optional<WalkNodeId> find(const GridCell& cell, double y, double tolerance = WalkNode::kLevel) const;
    /// All nodes at heights of the box, in cells that overlap it seen from above; by tile and node.
    std::vector<WalkNodeId> nodes_in(const collision::Aabb& box) const;
    /// Likewise, all nodes whose body may touch the box.
    std::vector<WalkNodeId> nodes_touching(const collision::Aabb& box,
                                           const collision::MoverSettings& body) const;
    std::optional<std::uint32_t> tile_at(const GridCell& cell) const;
    /// The tile's number; a tile that isn't there yet is added.
    std::uint32_t add_tile_at(const GridCell& cell);

    /// None for a start.
    std::optional<WalkNodeId> parent(const WalkNodeId& ref) const;
    /// From the start, from the middle of each cell to the next, metres.
    double length_to(const WalkNodeId& ref) const;
    /// From the start to the node. Takes as many ticks as the walk itself.
    std::vector<ChainLink> chain(const WalkNodeId& ref, Strider& strider) const;
    /// Where exactly the body stands at the node; takes the strides since the last node with a known state.
    GroundState state_at(const WalkNodeId& ref, Strider& strider) const;

private:
    std::unordered_map<GridCell, std::uint32_t, GridCellHash> tile_numbers_;  ///< by the tile's corner
};

}  // namespace campuswalk::engine
