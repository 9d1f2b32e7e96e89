#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
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
    double cell = 0.25;      ///< metres; smaller for a body narrower than a cell's diagonal
    bool keep_cell = false;  ///< not smaller, however narrow the body is: pockets may be taken for one
    /// Nothing is explored beyond this box; all of the world if it is empty.
    collision::Aabb within = {};
    /// Cells that this space has reached already aren't explored again. May be null.
    const WalkSpace* known = nullptr;
    const WalkSpace* also_known = nullptr;  ///< likewise, besides `known`; of cells of the same size
    bool steer_falls = true;  ///< also where that may lead to other ground; else Bound::steering
    bool keep_rim = false;    ///< fill WalkTile::rim
    std::size_t max_nodes = 60'000'000;
    /// Nodes that take longer to get to than this aren't explored any further: for ways across something.
    std::uint32_t max_ticks = std::numeric_limits<std::uint32_t>::max();
    /// Called now and then, with the nodes so far. May be empty.
    std::function<void(std::size_t nodes)> progress = {};
    /// Whether a node in this cell and at this height is what is looked for: the exploration ends soon after
    /// one is reached, see WalkSpace::goal. May be empty.
    std::function<bool(const GridCell&, double y)> is_goal = {};

    // For the way to a point. With one worker only.

    /// Takes the nodes in the order in which walking straight on from them would get to this point, so that
    /// hardly more than what lies on the way is explored. Ways that fall count as longer than they are.
    /// WalkNode::returns is then only set where that is obvious.
    std::optional<collision::Vec3> towards = {};
    /// As `is_goal`, by the exact state at a node. May be empty.
    std::function<bool(const GroundState&)> is_goal_state = {};
    /// Where the body must not come to stand, by its feet. May be empty.
    std::function<bool(const collision::Vec3& foot)> keep_out = {};
    /// Where it had rather not be: strides that end there count kTightFactor times. May be empty.
    std::function<bool(const collision::Vec3& foot)> is_tight = {};

    /// Whether what is known has reached that cell at this height.
    bool knows(const GridCell& there, double y, double tolerance = WalkNode::kLevel) const {
        return (known != nullptr && known->find(there, y, tolerance)) ||
               (also_known != nullptr && also_known->find(there, y, tolerance));
    }
};

/// Walks everywhere: from each node to the cells around it that have none at its height, until nothing new is
/// reached. The body leaves the ground where it can, and what it lands on is explored as well. The same
/// result for any number of workers.
WalkSpace explore(const WorkerWorlds& worlds, const ExploreSettings& settings);

/// A way that falls this far on a stride isn't longer for it, metres. Beyond that, visitors walk round it:
/// so many seconds for each metre.
inline constexpr double kHarmlessFall = 0.5;
inline constexpr double kSecondsRoundAFall = 10.0;
/// Visitors who prefer wide ways walk so much farther rather than through a tight place.
inline constexpr std::uint32_t kTightFactor = 4;

}  // namespace campuswalk::engine
