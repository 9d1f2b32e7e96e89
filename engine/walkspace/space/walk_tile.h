#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "engine/walkspace/stride/stride.h"
#include "engine/walkspace/stride/walk_grid.h"

namespace campuswalk::engine {

/// A place that the body can stand at: a cell and a height, reached by a chain of strides from a start.
struct WalkNode {
    /// Nodes of one cell are at least this far apart in height, metres: less than the lowest step that
    /// matters, more than the ground rises within a cell of a usual ramp.
    static constexpr double kLevel = 0.15;
    /// The same for a body that hangs over an edge: a little higher on it, it may get to where others in the
    /// cell don't.
    static constexpr double kHangingLevel = 0.02;
    static constexpr std::uint16_t kNone = 0xFFFF;
    /// Whether bodies so far apart in height, of which one hangs or not, are at one node.
    static bool is_one_level(double apart, bool hangs) {
        return std::abs(apart) <= (hangs ? kHangingLevel : kLevel);
    }

    float y = 0.0F;                ///< of the foot
    std::uint16_t next = kNone;    ///< another node of the same cell
    std::uint16_t parent = kNone;  ///< in the parent's tile
    std::uint32_t cell : 8 = 0;    ///< x + kCells * z in the tile
    std::uint32_t direction : 3 = 0;
    std::uint32_t gait : 2 = 0;
    std::uint32_t steering : 4 = 0;
    std::uint32_t parent_tile : 4 = 0;  ///< index of WalkTile::neighbours, or one of the codes below
    std::uint32_t returns : 1 = 0;      ///< one can walk back to the parent
    std::uint32_t steers_after : 3 = 0;
    std::uint32_t hangs : 1 = 0;  ///< see Strider::hangs
    std::uint32_t low : 1 = 0;    ///< no headroom to stand up, see Strider::has_headroom

    static constexpr std::uint32_t kFarParent = 9;  ///< in another tile: see WalkTile::far_parents
    static constexpr std::uint32_t kStart = 10;     ///< no parent: a start

    Stride stride() const {
        return {static_cast<std::uint8_t>(direction), static_cast<Gait>(gait),
                static_cast<std::uint8_t>(steering), static_cast<std::uint8_t>(steers_after)};
    }
};
static_assert(sizeof(WalkNode) == 12);

/// A node of a walk space.
struct WalkNodeId {
    std::uint32_t tile = 0;
    std::uint16_t node = 0;

    friend bool operator==(const WalkNodeId&, const WalkNodeId&) = default;
    friend auto operator<=>(const WalkNodeId&, const WalkNodeId&) = default;
};

/// 16 x 16 cells and their nodes. Threads work on tiles that aren't side by side, so that small ones are
/// shared out better, and a body moves on near where it was, where it knows what is around it; larger ones
/// would take less memory.
struct WalkTile {
    static constexpr int kCells = 16;
    static constexpr std::uint32_t kNoTile = std::numeric_limits<std::uint32_t>::max();
    static constexpr std::size_t kMaxNodes = WalkNode::kNone;

    /// Exact states are kept for some nodes only; those of the others follow from them, stride by stride.
    struct Keyframe {
        std::uint16_t node = 0;
        GroundState at;
    };
    struct FarParent {
        std::uint16_t node = 0;
        std::uint32_t tile = 0;
    };
    /// Where the body left the ground in a stride from a node, and fell out of the world: one for each cell
    /// and height.
    struct Drop {
        std::uint16_t node = 0;
        Stride stride;
        collision::Vec3 edge = collision::Vec3::Zero();
    };

    GridCell first_cell;                ///< its cell with the lowest x and z
    std::vector<std::uint16_t> newest;  ///< of each cell, a list by WalkNode::next
    std::vector<WalkNode> nodes;
    std::vector<Keyframe> keyframes;  ///< ascending by node
    /// Where a stride didn't get to the cell that it was headed for, in any order: at walls, steps and edges.
    std::vector<Keyframe> rim;
    std::vector<FarParent> far_parents;  ///< likewise
    std::vector<Drop> drops;             ///< out of the world
    /// The tiles around, row by row from the one with the lowest x and z; [4] is this one. kNoTile: none.
    std::array<std::uint32_t, 9> neighbours;

    WalkTile(const GridCell& lowest, std::uint32_t own_index);

    GridCell cell_of(const WalkNode& node) const {
        return {first_cell.x + static_cast<int>(node.cell) % kCells,
                first_cell.z + static_cast<int>(node.cell) / kCells};
    }
    /// The index in `neighbours` of the tile that has the cell, if that is no farther away; 4 for this one.
    std::size_t side_of(const GridCell& cell) const {
        const auto side = [](int at, int first) { return at < first ? 0U : at >= first + kCells ? 2U : 1U; };
        return side(cell.x, first_cell.x) + 3 * side(cell.z, first_cell.z);
    }
    bool contains(const GridCell& cell) const { return side_of(cell) == 4; }
    /// The index of a cell of this tile.
    std::uint32_t index_of(const GridCell& cell) const {
        return static_cast<std::uint32_t>(cell.x - first_cell.x + kCells * (cell.z - first_cell.z));
    }
    /// The cell's node nearest in height, within `tolerance`.
    std::optional<std::uint16_t> find(std::uint32_t cell, double y,
                                      double tolerance = WalkNode::kLevel) const;
    /// Whether the cell has a node that stands for a body at this height.
    bool has(std::uint32_t cell, double y, bool hangs) const;
    /// Adds a node to its cell's list. The tile must have room for it.
    std::uint16_t add(WalkNode node);
    /// Whether there is a drop from the edge's cell at its height.
    bool has_drop_from(const collision::Vec3& edge, const WalkGrid& grid) const;
    const GroundState* keyframe(std::uint16_t node) const;
};

}  // namespace campuswalk::engine
