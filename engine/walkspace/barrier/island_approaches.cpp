#include "engine/walkspace/barrier/island_approaches.h"

#include <cmath>
#include <memory>
#include <set>
#include <tuple>

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// Ways to it are looked for this much farther away, metres.
constexpr double kAroundPassage = 2.0;
/// Places on the rim that ways are looked for from: the nearest.
constexpr std::size_t kMostApproaches = 200;
/// Those on the rim are about this far apart, metres: nearer ones lead to the same.
constexpr double kApartOnRim = 0.5;
constexpr double kOneRimLevel = 0.5;
/// A spot's ground, in its cell, metres.
constexpr double kSpotGround = 0.3;
/// Stairs, ramps and long passages to an island begin no farther away than this from it, metres, and the
/// climbs lead no longer way to it.
constexpr double kFarFromIsland = 12.0;
constexpr double kLongestClimb = 30.0;

/// Heights count half: a way up or down is rather found than a way across.
double distance(const Vec3& a, const Vec3& b) {
    return collision::horizontal_norm(a - b) + 0.5 * std::abs(a.y() - b.y());
}

/// The nearest of those in one cell and at one height, and at most the nearest few.
void thin_out(std::vector<Approach>& approaches) {
    std::set<std::tuple<GridCell, int>> taken;
    std::erase_if(approaches, [&](const Approach& approach) {
        const Vec3& foot = approach.from.foot;
        const auto level = static_cast<int>(std::floor(foot.y() / kOneRimLevel));
        return !taken.emplace(WalkGrid{kApartOnRim}.cell_at(foot), level).second;
    });
    if (approaches.size() > kMostApproaches) {
        approaches.resize(kMostApproaches);
    }
}

/// A spot of an island.
struct SpotHeight {
    GridCell cell;
    double y = 0.0;  ///< metres
};

/// Those within the region, by cell. Islands may have millions of them.
std::vector<SpotHeight> heights_of(const Island& island, const WalkGrid& grid,
                                   const collision::Aabb& within) {
    std::vector<SpotHeight> heights;
    for (const UnreachedSpot& spot : island.spots) {
        if (within.overlaps({spot.at.foot, spot.at.foot})) {
            heights.push_back({grid.cell_at(spot.at.foot), spot.at.foot.y()});
        }
    }
    std::ranges::sort(heights, {}, &SpotHeight::cell);
    return heights;
}

/// Whether a node is on the island, for PassageQuery. Copies of it share the heights.
auto on_island(const Island& island, const WalkGrid& grid, const collision::Aabb& within) {
    const auto heights = std::make_shared<const std::vector<SpotHeight>>(heights_of(island, grid, within));
    return [heights](const GridCell& cell, double y) {
        // Not std::ranges::equal_range: its result is a subrange, which clang 14 can't compile with the
        // standard library of gcc 12.
        const auto first = std::ranges::lower_bound(*heights, cell, {}, &SpotHeight::cell);
        const auto last = std::ranges::upper_bound(*heights, cell, {}, &SpotHeight::cell);
        return std::any_of(first, last,
                           [&](const SpotHeight& spot) { return std::abs(spot.y - y) <= kSpotGround; });
    };
}

/// `ends`: of the way across, besides its starts.
PassageQuery passage_to(const IslandQuestion& q, const std::vector<Approach>& approaches,
                        const collision::Aabb& ends) {
    PassageQuery query;
    query.within = ends;
    for (const Approach& approach : approaches) {
        query.from.push_back(approach.from);
        query.within.extend(approach.from.foot);
    }
    query.within = query.within.grown(kAroundPassage);
    query.is_beyond = on_island(q.island, q.reached.grid, query.within);
    query.middle = q.island.bounds.center();
    query.known = {&q.reached};
    if (q.also_known != nullptr) {
        query.known.push_back(q.also_known);
    }
    query.nodes = q.nodes;
    return query;
}

}  // namespace

std::vector<Approach> approaches_to(const IslandQuestion& q) {
    const Island& island = q.island;
    Blocks<const UnreachedSpot*> spots;
    for (const UnreachedSpot& spot : island.spots) {
        spots.add(spot.at.foot, &spot);
    }
    std::vector<Approach> approaches;
    for (const auto& [block, there] : q.rim.all()) {
        const double x = kNearIsland * (block.x + 0.5);
        const double z = kNearIsland * (block.z + 0.5);
        if (x < island.bounds.min.x() - 2.0 * kNearIsland || x > island.bounds.max.x() + 2.0 * kNearIsland ||
            z < island.bounds.min.z() - 2.0 * kNearIsland || z > island.bounds.max.z() + 2.0 * kNearIsland) {
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
                collision::horizontal_norm(approach.spot->at.foot - from.foot) <= kNearIsland) {
                approaches.push_back(approach);
            }
        }
    }
    std::ranges::stable_sort(approaches, {}, &Approach::apart);
    thin_out(approaches);
    return approaches;
}

std::vector<Approach> approaches_from_afar(const IslandQuestion& q) {
    std::vector<Approach> starts;
    for (const auto& [block, there] : q.rim.all()) {
        for (const GroundState& from : there) {
            const Vec3 nearest = from.foot.cwiseMax(q.island.bounds.min).cwiseMin(q.island.bounds.max);
            const double apart = collision::horizontal_norm(nearest - from.foot);
            if (apart <= kFarFromIsland && from.foot.y() - q.island.bounds.max.y() < kHighestLedge) {
                starts.push_back({from, nullptr, apart});
            }
        }
    }
    std::ranges::stable_sort(starts, {}, &Approach::apart);
    return starts;
}

const Approach& lowest_of(const std::vector<Approach>& approaches) {
    return *std::ranges::min_element(approaches, {}, &Approach::rise);
}

PassageQuery passage_nearby(const IslandQuestion& q, const std::vector<Approach>& approaches) {
    collision::Aabb ends;
    for (const Approach& approach : approaches) {
        ends.extend(approach.spot->at.foot);
    }
    PassageQuery query = passage_to(q, approaches, ends);
    query.likely_riser = lowest_of(approaches).rise();
    return query;
}

std::optional<PassageQuery> passage_from_afar(const IslandQuestion& q, Changes changes) {
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
    query.longest_crossing = changes == Changes::climbs ? kLongestClimb : kFarFromIsland + kAroundPassage;
    return query;
}

}  // namespace campuswalk::engine
