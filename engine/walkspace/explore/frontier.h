#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "engine/walkspace/space/walk_space.h"

namespace campuswalk::engine {

/// A node whose strides are yet to be taken, or an arrival that is yet to become one.
struct Pending {
    enum class Strides : std::uint8_t { along_axes, diagonal, jumps };
    std::uint32_t order = 0;  ///< ticks, and those to the goal, if there is one
    std::uint32_t ticks = 0;  ///< of its chain
    std::uint16_t node = 0;   ///< or the number of a detour
    bool is_detour = false;
    std::uint8_t since_keyframe = 0;
    Strides next = Strides::along_axes;
    bool on_rim = false;           ///< one of the earlier strides didn't get to its cell
    std::uint8_t jumps_later = 0;  ///< a bit for each direction in which it hasn't jumped yet
    GroundState at;
};

/// What a stride leads to.
struct Arrival {
    std::uint32_t ticks = 0;  ///< of the chain with this stride
    WalkNodeId parent;
    Stride stride;
    bool returns = false;
    bool hangs = false;
    std::uint8_t since_keyframe = 0;
    GridCell cell;
    GroundState at;
};

/// A fall of which it is yet to be tried how it may be steered.
struct Fall {
    GroundState at;           ///< where the stride starts
    std::uint32_t ticks = 0;  ///< of the chain there
    Eigen::Vector3f edge =
        Eigen::Vector3f::Zero();  ///< where the body leaves the ground, as exactly as LandingPlaces needs it
    std::uint16_t node = 0;       ///< of `at`
    std::uint8_t since_keyframe = 0;
    std::uint8_t direction = 0;  ///< of the stride
    Gait gait = Gait::walk;
    bool high = false;
    bool gone = false;  ///< straight on, it goes out of the world

    Stride stride() const { return {.direction = direction, .gait = gait}; }
    /// What the stride starts from.
    Pending from() const {
        return {.ticks = ticks, .node = node, .since_keyframe = since_keyframe, .at = at};
    }
};

/// What is left to do in a tile while it is explored.
class Frontier {
public:
    std::optional<std::uint16_t> goal;  ///< the first node that is one
    std::vector<Arrival> outbox;        ///< in other tiles, for which they are still to be added
    std::vector<Fall> falls;

    bool is_empty() const { return pending_.empty(); }
    /// Of the next one; there must be one.
    std::uint32_t next_order() const { return pending_.front().order; }
    void push(const Pending& node);
    Pending pop();

    /// A fall on the way to a point: it becomes a node only where nothing better is found in the time that it
    /// counts for. False if there are too many.
    bool push_detour(const Arrival& arrival, std::uint32_t order);
    const Arrival& detour(std::uint16_t number) const { return detours_[number]; }

    /// Whether the outbox has an arrival in this cell and at this height.
    bool has_sent(const GridCell& cell, double y, bool hangs) const;
    /// The height of the one in this cell that is nearest to `y`, within `tolerance`.
    std::optional<double> level_sent(const GridCell& cell, double y, double tolerance) const;
    /// Keeps the fall unless there is one from this cell and height of an edge already.
    void keep(const Fall& fall, const GridCell& edge);

private:
    std::vector<Pending> pending_;  ///< a heap
    std::vector<Arrival> detours_;
    std::vector<std::pair<GridCell, float>> edges_;  ///< that falls were kept from, each with its height
};

/// The fall's stride steered elsewhere: what is tried after letting the body fall straight down.
/// `over_the_rim`: both straight on and straight down, it goes out of the world.
std::vector<Stride> steered_strides(const Fall& fall, bool over_the_rim);

}  // namespace campuswalk::engine
