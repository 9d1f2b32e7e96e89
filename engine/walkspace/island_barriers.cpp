#include "engine/walkspace/island_barriers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "engine/walkspace/hollows.h"
#include "engine/walkspace/worker_threads.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// Ground farther from an island than this has no part in why it isn't reached, metres.
constexpr double kNear = 2.0;
/// Ways to it are looked for this much farther away, metres.
constexpr double kAround = 2.0;
/// Places on the rim that ways are looked for from: the nearest.
constexpr std::size_t kMostStarts = 200;
/// Those on the rim are about this far apart, metres: nearer ones lead to the same.
constexpr double kApart = 0.5;
constexpr double kOneLevel = 0.5;
/// A spot's ground, in its cell, metres.
constexpr double kSameGround = 0.3;
/// Stairs to an island begin no farther away than this from it, metres, and lead no longer way to it.
constexpr double kStairs = 12.0;
constexpr double kLongestStairs = 30.0;

/// Places by blocks of 2 m.
template <typename Place>
class Blocks {
public:
    void add(const Vec3& at, const Place& place) { blocks_[block_of(at)].push_back(place); }

    /// Calls `visit` for those in the block of `place` and around it.
    template <typename Visit>
    void visit_around(const Vec3& place, const Visit& visit) const {
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
    static GridCell block_of(const Vec3& place) { return WalkGrid{kNear}.cell_at(place); }

    std::map<GridCell, std::vector<Place>> blocks_;
};

using Rim = Blocks<GroundState>;

/// A place on the rim and the island's nearest spot.
struct Approach {
    GroundState from;
    const UnreachedSpot* spot = nullptr;
    double apart = 1e300;
};

/// Heights count half: a way up or down is rather found than a way across.
double distance(const Vec3& a, const Vec3& b) {
    return collision::horizontal_norm(a - b) + 0.5 * std::abs(a.y() - b.y());
}

std::vector<Approach> approaches_to(const Island& island, const Rim& rim) {
    Blocks<const UnreachedSpot*> spots;
    for (const UnreachedSpot& spot : island.spots) {
        spots.add(spot.at.foot, &spot);
    }
    std::vector<Approach> approaches;
    for (const auto& [block, there] : rim.all()) {
        const double x = kNear * (block.x + 0.5);
        const double z = kNear * (block.z + 0.5);
        if (x < island.bounds.min.x() - 2.0 * kNear || x > island.bounds.max.x() + 2.0 * kNear ||
            z < island.bounds.min.z() - 2.0 * kNear || z > island.bounds.max.z() + 2.0 * kNear) {
            continue;
        }
        for (const GroundState& from : there) {
            Approach approach{from};
            spots.visit_around(from.foot, [&](const UnreachedSpot* spot) {
                if (const double apart = distance(spot->at.foot, from.foot); apart < approach.apart) {
                    approach.apart = apart;
                    approach.spot = spot;
                }
            });
            if (approach.spot != nullptr &&
                collision::horizontal_norm(approach.spot->at.foot - from.foot) <= kNear) {
                approaches.push_back(approach);
            }
        }
    }
    std::ranges::stable_sort(approaches, {}, &Approach::apart);
    return approaches;
}

/// The nearest of those in one cell and at one height, and at most the nearest few.
void thin_out(std::vector<Approach>& approaches) {
    std::set<std::tuple<GridCell, int>> taken;
    std::erase_if(approaches, [&](const Approach& approach) {
        const Vec3& foot = approach.from.foot;
        const auto level = static_cast<int>(std::floor(foot.y() / kOneLevel));
        return !taken.emplace(WalkGrid{kApart}.cell_at(foot), level).second;
    });
    if (approaches.size() > kMostStarts) {
        approaches.resize(kMostStarts);
    }
}

/// The heights of an island's spots by cell.
using Heights = std::map<GridCell, std::vector<double>>;

Heights heights_of(const Island& island, const WalkGrid& grid, const collision::Aabb& within) {
    Heights heights;
    for (const UnreachedSpot& spot : island.spots) {
        if (within.overlaps({spot.at.foot, spot.at.foot})) {
            heights[grid.cell_at(spot.at.foot)].push_back(spot.at.foot.y());
        }
    }
    return heights;
}

/// Whether a node is on the island, for PassageQuery.
auto on_island(const Island& island, const WalkGrid& grid, const collision::Aabb& within) {
    return [heights = heights_of(island, grid, within)](const GridCell& cell, double y) {
        const auto there = heights.find(cell);
        return there != heights.end() && std::ranges::any_of(there->second, [&](double height) {
                   return std::abs(height - y) <= kSameGround;
               });
    };
}

/// A riser of the stairs to an island, if such are what would lead there. Where their treads are too narrow
/// to stand on, they are no part of the island, and begin farther away from it than other barriers are.
std::optional<Barrier> riser_of_stairs(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                       const WalkSpace& reached, const Island& island, const Rim& rim) {
    std::vector<Approach> feet;
    for (const auto& [block, there] : rim.all()) {
        for (const GroundState& from : there) {
            const Vec3 nearest = from.foot.cwiseMax(island.bounds.min).cwiseMin(island.bounds.max);
            const double apart = collision::horizontal_norm(nearest - from.foot);
            if (apart <= kStairs && from.foot.y() < island.bounds.max.y()) {
                feet.push_back({from, nullptr, apart});
            }
        }
    }
    std::ranges::stable_sort(feet, {}, &Approach::apart);
    thin_out(feet);
    PassageQuery query;
    query.within = island.bounds;
    for (const Approach& foot : feet) {
        query.from.push_back(foot.from);
        query.within.extend(foot.from.foot);
    }
    query.within = query.within.grown(kAround);
    query.is_beyond = on_island(island, reached.grid, query.within);
    query.known = &reached;
    query.only_risers = true;
    query.longest_crossing = kLongestStairs;
    return query.from.empty() ? std::nullopt : why_not(worlds, settings, query);
}

std::optional<Barrier> barrier_before(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                      const WalkSpace& reached, const Island& island, const Rim& rim,
                                      const scene::NodeTriangles* nodes) {
    std::vector<Approach> approaches = approaches_to(island, rim);
    thin_out(approaches);
    if (approaches.empty()) {
        return std::nullopt;
    }
    const auto rise = [](const Approach& a) { return a.spot->at.foot.y() - a.from.foot.y(); };
    const Approach& lowest = *std::ranges::min_element(approaches, {}, rise);
    Barrier ledge;
    ledge.kind = BarrierKind::ledge;
    ledge.measured = rise(lowest);
    ledge.allowed = settings.strides.body.step_height;
    ledge.at = lowest.spot->at.foot;
    ledge.object = lowest.spot->object;
    ledge.triangle = lowest.spot->triangle;
    ledge.from = lowest.from.foot;
    if (ledge.measured > kHighestLedge) {
        return ledge;
    }
    PassageQuery query;
    for (const Approach& approach : approaches) {
        query.from.push_back(approach.from);
        query.within.extend(approach.from.foot);
        query.within.extend(approach.spot->at.foot);
    }
    query.within = query.within.grown(kAround);
    query.is_beyond = on_island(island, reached.grid, query.within);
    query.middle = island.bounds.center();
    query.known = &reached;
    query.nodes = nodes;
    query.likely_riser = ledge.measured;
    std::optional<bool> enclosed;
    query.is_enclosed = [&] {
        if (!enclosed) {
            enclosed = is_enclosed(worlds[0], settings, reached, island);
        }
        return *enclosed;
    };
    std::optional<Barrier> barrier = why_not(worlds, settings, query);
    const bool is_closed_off = barrier && barrier->kind == BarrierKind::solid;
    const bool is_ledge = is_closed_off && ledge.measured > kHighestRiser && !query.is_enclosed();
    return is_ledge ? ledge : barrier;
}

}  // namespace

std::vector<std::optional<Barrier>> find_island_barriers(const WorkerWorlds& worlds,
                                                         const ExploreSettings& settings,
                                                         const WalkSpace& reached,
                                                         const std::vector<Island>& islands,
                                                         std::size_t count, const scene::NodeTriangles* nodes,
                                                         const std::vector<bool>& with_stairs) {
    Rim rim;
    for (const WalkTile& tile : reached.tiles) {
        for (const WalkTile::Keyframe& at : tile.rim) {
            rim.add(at.at.foot, at.at);
        }
    }
    std::vector<std::optional<Barrier>> barriers(std::min(count, islands.size()));
    for_each_item(barriers.size(), worlds.size(), [&](std::size_t worker, std::size_t island) {
        const WorkerWorlds own(worlds[worker], 1, {});
        std::optional<Barrier>& barrier = barriers[island];
        barrier = barrier_before(own, settings, reached, islands[island], rim, nodes);
        const bool asks_for_stairs = island < with_stairs.size() && with_stairs[island];
        if (asks_for_stairs && barrier && barrier->kind == BarrierKind::ledge) {
            const auto riser = riser_of_stairs(own, settings, reached, islands[island], rim);
            barrier = riser ? riser : barrier;
        }
    });
    return barriers;
}

}  // namespace campuswalk::engine
