#include "engine/walkspace/island_barriers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "engine/walkspace/ground_gap.h"
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
/// Stairs, ramps and long passages to an island begin no farther away than this from it, metres, and the
/// climbs lead no longer way to it.
constexpr double kFar = 12.0;
constexpr double kLongestClimb = 30.0;

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

/// The island, and what it takes to ask about it.
struct IslandQuestion {
    const WorkerWorlds& worlds;
    const ExploreSettings& settings;
    const WalkSpace& reached;
    const Island& island;
    const Rim& rim;
    const scene::NodeTriangles* nodes;
};

/// `ends`: of the way across, besides its starts.
PassageQuery passage_to(const IslandQuestion& q, const std::vector<Approach>& approaches,
                        const collision::Aabb& ends) {
    PassageQuery query;
    query.within = ends;
    for (const Approach& approach : approaches) {
        query.from.push_back(approach.from);
        query.within.extend(approach.from.foot);
    }
    query.within = query.within.grown(kAround);
    query.is_beyond = on_island(q.island, q.reached.grid, query.within);
    query.middle = q.island.bounds.center();
    query.known = &q.reached;
    query.nodes = q.nodes;
    return query;
}

/// Where a body stands that might get to the island from no farther than kFar: the nearest first.
std::vector<Approach> approaches_from_afar(const IslandQuestion& q) {
    std::vector<Approach> starts;
    for (const auto& [block, there] : q.rim.all()) {
        for (const GroundState& from : there) {
            const Vec3 nearest = from.foot.cwiseMax(q.island.bounds.min).cwiseMin(q.island.bounds.max);
            const double apart = collision::horizontal_norm(nearest - from.foot);
            if (apart <= kFar && from.foot.y() - q.island.bounds.max.y() < kHighestLedge) {
                starts.push_back({from, nullptr, apart});
            }
        }
    }
    std::ranges::stable_sort(starts, {}, &Approach::apart);
    return starts;
}

/// What keeps the body from the island where nothing of it is near: stairs whose treads are too narrow to
/// stand on and ramps too steep to stand on are no part of it, nor is a passage without room.
std::optional<Barrier> barrier_from_afar(const IslandQuestion& q, Changes changes) {
    std::vector<Approach> starts = approaches_from_afar(q);
    if (changes == Changes::climbs) {
        std::erase_if(starts,
                      [&](const Approach& start) { return start.from.foot.y() >= q.island.bounds.max.y(); });
    }
    thin_out(starts);
    if (starts.empty()) {
        return std::nullopt;
    }
    PassageQuery query = passage_to(q, starts, q.island.bounds);
    query.changes = changes;
    query.longest_crossing = changes == Changes::climbs ? kLongestClimb : kFar + kAround;
    return why_not(q.worlds, q.settings, query);
}

std::optional<Barrier> gap_before(const IslandQuestion& q) {
    std::vector<GroundState> reached;
    for (const Approach& approach : approaches_from_afar(q)) {
        reached.push_back(approach.from);
    }
    return find_gap(q.worlds[0], q.settings, q.island, reached);
}

/// The lowest step up to the island from what is near it.
Barrier lowest_ledge(const std::vector<Approach>& approaches, double step_height) {
    const auto rise = [](const Approach& a) { return a.spot->at.foot.y() - a.from.foot.y(); };
    const Approach& lowest = *std::ranges::min_element(approaches, {}, rise);
    Barrier ledge;
    ledge.kind = BarrierKind::ledge;
    ledge.measured = rise(lowest);
    ledge.allowed = step_height;
    ledge.at = lowest.spot->at.foot;
    ledge.object = lowest.spot->object;
    ledge.triangle = lowest.spot->triangle;
    ledge.from = lowest.from.foot;
    return ledge;
}

bool is_closed_off(const std::optional<Barrier>& barrier) {
    return barrier && barrier->kind == BarrierKind::solid;
}

/// Whether it is an object, and the other one too, but a larger one.
bool is_smaller_object(const collision::World& world, const Barrier& barrier, const Barrier& other) {
    const auto size_of = [&](const Barrier& object) {
        const collision::Aabb& box = world.bounds(*object.object);
        return (box.max - box.min).norm();
    };
    return barrier.kind == BarrierKind::object && other.kind == BarrierKind::object &&
           size_of(barrier) <= size_of(other);
}

/// `approaches`: at least one. `is_wanted`: see find_island_barriers.
std::optional<Barrier> barrier_from_nearby(const IslandQuestion& q, const std::vector<Approach>& approaches,
                                           bool is_wanted) {
    const Barrier ledge = lowest_ledge(approaches, q.settings.strides.body.step_height);
    if (ledge.measured > kHighestLedge) {
        return ledge;
    }
    collision::Aabb ends;
    for (const Approach& approach : approaches) {
        ends.extend(approach.spot->at.foot);
    }
    PassageQuery query = passage_to(q, approaches, ends);
    query.likely_riser = ledge.measured;
    std::optional<bool> enclosed;
    query.is_enclosed = [&] {
        if (!enclosed) {
            enclosed = is_enclosed(q.worlds[0], q.settings, q.reached, q.island);
        }
        return *enclosed;
    };
    if (is_wanted) {
        query.changes = Changes::single;
        std::optional<Barrier> here = why_not(q.worlds, q.settings, query);
        if (here && here->kind != BarrierKind::solid && here->kind != BarrierKind::object) {
            return here;
        }
        // One change that helps from afar is better than several here, or than to take away a wall.
        const std::optional<Barrier> afar = barrier_from_afar(q, Changes::single);
        if (afar && !is_closed_off(afar) && !(here && is_smaller_object(q.worlds[0], *here, *afar))) {
            return afar;
        }
        if (!is_closed_off(here)) {
            return here;
        }
        query.changes = Changes::any;
    }
    std::optional<Barrier> barrier = why_not(q.worlds, q.settings, query);
    const bool is_ledge = is_closed_off(barrier) && ledge.measured > kHighestRiser && !query.is_enclosed();
    return is_ledge ? ledge : barrier;
}

std::optional<Barrier> barrier_before(const IslandQuestion& q, bool is_wanted) {
    std::vector<Approach> approaches = approaches_to(q.island, q.rim);
    thin_out(approaches);
    if (approaches.empty()) {
        const auto barrier = is_wanted ? barrier_from_afar(q, Changes::single) : std::nullopt;
        const bool is_explained = barrier && !is_closed_off(barrier);
        const auto gap = is_explained ? std::nullopt : gap_before(q);
        return gap ? gap : barrier;
    }
    std::optional<Barrier> barrier = barrier_from_nearby(q, approaches, is_wanted);
    if (is_wanted && barrier && barrier->kind == BarrierKind::ledge) {
        const auto climb = barrier_from_afar(q, Changes::climbs);
        return climb ? climb : barrier;
    }
    return barrier;
}

}  // namespace

std::vector<std::optional<Barrier>> find_island_barriers(const WorkerWorlds& worlds,
                                                         const ExploreSettings& settings,
                                                         const WalkSpace& reached,
                                                         const std::vector<Island>& islands,
                                                         std::size_t count, const scene::NodeTriangles* nodes,
                                                         const std::vector<bool>& wanted) {
    Rim rim;
    for (const WalkTile& tile : reached.tiles) {
        for (const WalkTile::Keyframe& at : tile.rim) {
            rim.add(at.at.foot, at.at);
        }
    }
    std::vector<std::optional<Barrier>> barriers(std::min(count, islands.size()));
    for_each_item(barriers.size(), worlds.size(), [&](std::size_t worker, std::size_t island) {
        const WorkerWorlds own(worlds[worker], 1, {});
        const bool is_wanted = island < wanted.size() && wanted[island];
        barriers[island] = barrier_before({own, settings, reached, islands[island], rim, nodes}, is_wanted);
    });
    return barriers;
}

}  // namespace campuswalk::engine
