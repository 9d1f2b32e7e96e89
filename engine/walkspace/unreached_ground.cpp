#include "engine/walkspace/unreached_ground.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "collision/mover/mover.h"
#include "collision/world/placement.h"
#include "engine/walkspace/unreached_surfaces.h"
#include "engine/walkspace/worker_threads.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// A round body rests this much higher on a slope of 50 degrees, as a share of its radius, and less on
/// others.
constexpr double kRiseOnSlope = 0.56;

/// Where a body comes to stand on the surface, if it has room there.
std::optional<GroundState> stand_on(const Surface& surface, const collision::CapsuleMover& mover,
                                    const collision::World& world, const ExploreSettings& settings,
                                    const WalkGrid& grid, collision::MoverCache& cache) {
    const collision::MoverSettings& body = settings.strides.body;
    Vec3 foot = grid.center(surface.cell);
    foot.y() = surface.y + collision::kRestGap;
    const double rise = kRiseOnSlope * body.radius;
    const auto free = collision::free_place(world, settings.solids, foot, body.radius, body.height, rise);
    if (!free) {
        return std::nullopt;
    }
    collision::MoverState state;
    mover.place(state, *free + Vec3(0, 0.01, 0), rise + 0.05, cache);
    if (!state.grounded) {
        return std::nullopt;
    }
    return GroundState{state.foot, state.support_y};
}

std::vector<UnreachedSpot> spots_with_room(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                           const WalkSpace& reached, const std::vector<Surface>& surfaces) {
    constexpr std::size_t kChunk = 256;
    std::vector<std::optional<GroundState>> found(surfaces.size());
    std::vector<collision::MoverCache> caches(worlds.size());
    std::vector<collision::CapsuleMover> movers;
    for (std::size_t i = 0; i < worlds.size(); ++i) {
        movers.emplace_back(worlds[i], settings.strides.body, settings.solids);
    }
    const std::size_t chunks = (surfaces.size() + kChunk - 1) / kChunk;
    for_each_item(chunks, worlds.size(), [&](std::size_t worker, std::size_t chunk) {
        const std::size_t end = std::min(surfaces.size(), (chunk + 1) * kChunk);
        for (std::size_t i = chunk * kChunk; i < end; ++i) {
            found[i] =
                stand_on(surfaces[i], movers[worker], worlds[worker], settings, reached.grid, caches[worker]);
        }
    });
    std::vector<UnreachedSpot> spots;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (found[i]) {
            spots.push_back({*found[i], surfaces[i].object, surfaces[i].triangle});
        }
    }
    return spots;
}

/// Joins the spots between which one can walk.
class SpotJoiner {
public:
    SpotJoiner(const WorkerWorlds& worlds, const ExploreSettings& settings, const WalkGrid& grid,
               const std::vector<UnreachedSpot>& spots)
        : grid_(grid),
          spots_(spots),
          sets_(spots.size()),
          strider_(worlds[0], settings.strides, settings.solids),
          step_(settings.strides.body.step_height + collision::kHeightSlack) {
        slope_ = std::max(step_, settings.strides.body.steepest_rise() * grid.cell);
        join_neighbours();
        join_by_steps();
    }

    collision::DisjointSets& sets() { return sets_; }

private:
    GridCell cell_of(const UnreachedSpot& spot) const { return grid_.cell_at(spot.at.foot); }

    /// Calls `visit` for the number of each spot in the cell, up to so far above or below.
    template <typename Visit>
    void visit_spots(const GridCell& cell, double y, double apart, const Visit& visit) const {
        const auto own_cell = [&](const UnreachedSpot& spot) { return cell_of(spot); };
        auto spot = std::ranges::lower_bound(spots_, cell, {}, own_cell);
        for (; spot != spots_.end() && cell_of(*spot) == cell; ++spot) {
            if (std::abs(spot->at.foot.y() - y) <= apart) {
                visit(static_cast<std::size_t>(spot - spots_.begin()));
            }
        }
    }

    void join_neighbours() {
        for (std::size_t i = 0; i < spots_.size(); ++i) {
            const GridCell cell = cell_of(spots_[i]);
            for (const GridCell& beside : {GridCell{cell.x + 1, cell.z}, GridCell{cell.x, cell.z + 1}}) {
                visit_spots(beside, spots_[i].at.foot.y(), slope_,
                            [&](std::size_t other) { sets_.join(i, other); });
            }
        }
    }

    /// On stairs there is no room to stand in every cell: between the treads it is walked.
    void join_by_steps() {
        for (std::size_t i = 0; i < spots_.size(); ++i) {
            const GridCell cell = cell_of(spots_[i]);
            for (int k = 0; k < 49; ++k) {
                visit_spots({cell.x + k % 7 - 3, cell.z + k / 7 - 3}, spots_[i].at.foot.y() + 0.5 * step_,
                            0.5 * step_, [&](std::size_t higher) { join_if_walkable(i, higher); });
            }
        }
    }

    void join_if_walkable(std::size_t lower, std::size_t higher) {
        constexpr int kTries = 24;
        const auto pair = std::pair(sets_.root(lower), sets_.root(higher));
        if (pair.first == pair.second || tries_[pair]++ >= kTries) {
            return;
        }
        const Vec3& goal = spots_[higher].at.foot;
        const StrideEnd end = strider_.walk_to(spots_[lower].at, goal, 0.05, 1.5);
        if (end.kind == StrideEnd::Kind::grounded && (end.at.foot - goal).norm() <= WalkNode::kLevel) {
            sets_.join(lower, higher);
        }
    }

    const WalkGrid& grid_;
    const std::vector<UnreachedSpot>& spots_;  ///< by cell
    collision::DisjointSets sets_;
    Strider strider_;
    double step_;
    double slope_ = 0.0;
    std::map<std::pair<std::size_t, std::size_t>, int> tries_;
};

}  // namespace

Vec3 Island::nearest_to(const Vec3& point) const {
    const auto apart = [&](const UnreachedSpot& spot) {
        const Vec3 path = spot.at.foot - point;
        return collision::horizontal_norm(path) + 0.5 * std::abs(path.y());
    };
    return std::ranges::min_element(spots, {}, apart)->at.foot;
}

std::vector<Island> find_unreached_ground(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                          const WalkSpace& reached, double least_area) {
    const collision::Aabb& region = settings.within.empty() ? worlds[0].bounds() : settings.within;
    const std::vector<Surface> surfaces = unreached_surfaces(worlds, settings, reached, region);
    const std::vector<UnreachedSpot> spots = spots_with_room(worlds, settings, reached, surfaces);
    SpotJoiner joiner(worlds, settings, reached.grid, spots);
    return islands_of(spots, joiner.sets(), reached.grid, least_area);
}

std::vector<Island> islands_of(const std::vector<UnreachedSpot>& spots, collision::DisjointSets& sets,
                               const WalkGrid& grid, double least_area) {
    std::map<std::size_t, Island> by_root;
    for (std::size_t i = 0; i < spots.size(); ++i) {
        Island& island = by_root[sets.root(i)];
        island.spots.push_back(spots[i]);
        island.bounds.extend(spots[i].at.foot);
    }
    std::vector<Island> islands;
    for (auto& [root, island] : by_root) {
        if (island.area(grid) >= least_area) {
            islands.push_back(std::move(island));
        }
    }
    std::ranges::stable_sort(islands, std::greater(), [](const Island& i) { return i.spots.size(); });
    return islands;
}

}  // namespace campuswalk::engine
