#pragma once

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "engine/walkspace/barrier/why_not.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/explore/unreached_ground.h"
#include "engine/walkspace/stride/worker_worlds.h"

namespace campuswalk::engine {

/// Ground farther from an island than this has no part in why it isn't reached, metres.
inline constexpr double kNearIsland = 2.0;

/// Places by blocks of 2 m.
template <typename Place>
class Blocks {
public:
    void add(const collision::Vec3& at, const Place& place) { blocks_[block_of(at)].push_back(place); }

    /// Calls `visit` for those in the block of `place` and around it.
    template <typename Visit>
    void visit_around(const collision::Vec3& place, const Visit& visit) const {
        const GridCell center = block_of(place);
        for (int dx = -1; dx <= 1; ++dx) {
            for (int dz = -1; dz <= 1; ++dz) {
                const auto block = blocks_.find({center.x + dx, center.z + dz});
                if (block != blocks_.end()) {
                    std::ranges::for_each(block->second, visit);
                }
            }
        }
    }
    const std::map<GridCell, std::vector<Place>>& all() const { return blocks_; }

private:
    static GridCell block_of(const collision::Vec3& place) { return WalkGrid{kNearIsland}.cell_at(place); }

    std::map<GridCell, std::vector<Place>> blocks_;
};

/// The edges of the ground from which ways to islands are looked for.
using Rim = Blocks<GroundState>;

/// An island, and what it takes to ask why one doesn't get to it from a rim.
struct IslandQuestion {
    const WorkerWorlds& worlds;
    const ExploreSettings& settings;
    const WalkSpace& reached;
    const Island& island;
    const Rim& rim;
    const scene::NodeTriangles* nodes;      ///< see PassageQuery
    const WalkSpace* also_known = nullptr;  ///< besides `reached`; may be null
};

/// A place on the rim and the island's nearest spot.
struct Approach {
    GroundState from;
    const UnreachedSpot* spot = nullptr;
    double apart = std::numeric_limits<double>::max();

    /// How much higher the spot is, metres.
    double rise() const { return spot->at.foot.y() - from.foot.y(); }
};

/// From the rim to the spots within kNearIsland of it, the nearest first: few, each for many beside it.
std::vector<Approach> approaches_to(const IslandQuestion& q);

/// Where a body stands that might get to the island from no farther than 12 m, without a spot: the nearest
/// first, all of them.
std::vector<Approach> approaches_from_afar(const IslandQuestion& q);

/// Of approaches, at least one: the one with the lowest rise.
const Approach& lowest_of(const std::vector<Approach>& approaches);

/// For ways from these approaches, at least one, to the island.
PassageQuery passage_nearby(const IslandQuestion& q, const std::vector<Approach>& approaches);

/// For ways that begin as far as 12 m away: stairs whose treads are too narrow to stand on and ramps too
/// steep to stand on are no part of an island, nor is a passage without room. None if the rim is farther.
std::optional<PassageQuery> passage_from_afar(const IslandQuestion& q, Changes changes);

}  // namespace campuswalk::engine
