#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include "collision/geometry/shapes.h"
#include "engine/walkspace/space/walk_space.h"
#include "engine/walkspace/stride/worker_worlds.h"

namespace campuswalk::engine {

/// What is explored, and by whom.
struct ExploreSettings {
    StrideSettings strides;
    collision::QueryFilter solids;              ///< what it points to must outlive the exploration
    std::vector<collision::Vec3> starts;        ///< feet, put down as a spawn is
    std::vector<GroundState> more_starts = {};  ///< bodies that stand already
    bool run = false;                           ///< may also run: off edges it gets farther
    bool jump = false;                          ///< may also jump, forward at the speed of its run
    /// Without one, cells are no wider than the body: two pockets of free space in a cell may be taken for
    /// one.
    std::optional<WalkGrid> grid = {};
    /// Nothing is explored beyond this box; all of the world if it is empty.
    collision::Aabb within = {};
    /// Cells that these spaces have reached already aren't explored again. Their grid must be the `grid`.
    std::vector<const WalkSpace*> known = {};
    bool steer_falls = true;  ///< also where that may lead to other ground; else Bound::steering
    bool keep_rim = false;    ///< fill WalkTile::rim
    /// Where the body must not come to stand, by its feet; all workers ask it at once. May be empty.
    std::function<bool(const collision::Vec3& foot)> keep_out = {};
    std::size_t max_nodes = 60'000'000;
    /// Nodes that take longer to get to than this aren't explored any further: for ways across something.
    std::uint32_t max_ticks = std::numeric_limits<std::uint32_t>::max();
    /// Called now and then, with the nodes so far. May be empty.
    std::function<void(std::size_t nodes)> progress = {};

    /// Whether what is known has reached that cell at this height.
    bool knows(const GridCell& there, double y) const {
        return std::ranges::any_of(known,
                                   [&](const WalkSpace* space) { return space->find(there, y).has_value(); });
    }
};

/// The exploration ends where nothing new is reached.
struct Everywhere {};

/// The exploration ends soon after it has reached a node in a cell, and at a height, for which this is true.
/// See WalkSpace::goal.
struct UntilCell {
    std::function<bool(const GridCell&, double y)> is_goal;
};

/// The exploration takes the nodes in the order in which walking straight on from them would get to the
/// point, so that hardly more than what lies on the way is explored. Ways that fall count as longer than they
/// are. With more than one worker explore() throws std::invalid_argument. WalkNode::returns is then only set
/// where that is obvious.
struct TowardsPoint {
    collision::Vec3 point;
    std::function<bool(const GroundState&)> is_goal;  ///< asked about the exact state at a node
    /// Where the body had rather not be: strides that end there count kTightFactor times. May be empty.
    std::function<bool(const collision::Vec3& foot)> is_tight = {};
};

using ExploreGoal = std::variant<Everywhere, UntilCell, TowardsPoint>;

/// Walks to the goal: from each node to the cells around it that have none at its height, until nothing new
/// is reached. The body leaves the ground where it can, and what it lands on is explored as well. The same
/// result for any number of workers.
WalkSpace explore(const WorkerWorlds& worlds, const ExploreSettings& settings,
                  const ExploreGoal& goal = Everywhere());

/// A way that falls this far on a stride isn't longer for it, metres. Beyond that, visitors walk round it:
/// so many seconds for each metre.
inline constexpr double kHarmlessFall = 0.5;
inline constexpr double kSecondsRoundAFall = 10.0;
/// Visitors who prefer wide ways walk so much farther rather than through a tight place.
inline constexpr std::uint32_t kTightFactor = 4;

}  // namespace campuswalk::engine
