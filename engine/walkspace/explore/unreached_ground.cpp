#include "engine/walkspace/explore/unreached_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "collision/mover/mover.h"
#include "collision/world/placement.h"
#include "engine/walkspace/stride/worker_threads.h"

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
                                           const WalkSpace& reached, std::vector<Surface> surfaces) {
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
    spots.reserve(static_cast<std::size_t>(
        std::ranges::count_if(found, [](const auto& state) { return state.has_value(); })));
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
        : spots_(spots),
          sets_(spots.size()),
          strider_(worlds[0], settings.strides, settings.solids),
          step_(settings.strides.body.step_height + collision::kHeightSlack) {
        cells_.reserve(spots.size());
        for (const UnreachedSpot& spot : spots) {
            cells_.push_back(grid.cell_at(spot.at.foot));
        }
        slope_ = std::max(step_, settings.strides.body.steepest_rise() * grid.cell);
        join_neighbours();
        join_by_steps();
    }

    collision::DisjointSets& sets() { return sets_; }

private:
    double height(std::size_t spot) const { return spots_[spot].at.foot.y(); }

    /// Calls `visit(spot, near)` for each spot and those at most `kFar` cells from it along both axes.
    template <int kFar, typename Visit>
    void for_each_near(const Visit& visit) const {
        std::array<std::size_t, std::size_t{2} * kFar + 1> first{};  // in each column: what is near enough
        for (std::size_t spot = 0; spot < spots_.size(); ++spot) {
            const GridCell cell = cells_[spot];
            const bool is_new_column = spot == 0 || cells_[spot - 1].x != cell.x;
            for (int x = -kFar; x <= kFar; ++x) {
                const GridCell from{cell.x + x, cell.z - kFar};
                const int column = x + kFar;
                std::size_t& near = first[static_cast<std::size_t>(column)];
                if (is_new_column) {
                    near = static_cast<std::size_t>(std::ranges::lower_bound(cells_, from) - cells_.begin());
                }
                while (near < cells_.size() && cells_[near] < from) {
                    ++near;
                }
            }
            auto next = first;
            for (int z = -kFar; z <= kFar; ++z) {
                for (int x = -kFar; x <= kFar; ++x) {
                    const int column = x + kFar;
                    std::size_t& near = next[static_cast<std::size_t>(column)];
                    for (; near < cells_.size() && cells_[near] == GridCell{cell.x + x, cell.z + z}; ++near) {
                        visit(spot, near);
                    }
                }
            }
        }
    }

    void join_neighbours() {
        for_each_near<1>([&](std::size_t spot, std::size_t near) {
            const bool side_by_side =
                (cells_[spot].x == cells_[near].x) != (cells_[spot].z == cells_[near].z);
            if (side_by_side && std::abs(height(near) - height(spot)) <= slope_) {
                sets_.join(spot, near);
            }
        });
    }

    /// On stairs there is no room to stand in every cell: between the treads it is walked.
    void join_by_steps() {
        for_each_near<3>([&](std::size_t spot, std::size_t near) {
            if (std::abs(height(near) - (height(spot) + 0.5 * step_)) <= 0.5 * step_) {
                join_if_walkable(spot, near);
            }
        });
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

    const std::vector<UnreachedSpot>& spots_;  ///< by cell
    std::vector<GridCell> cells_;
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

std::optional<std::vector<Island>> find_unreached_ground(const WorkerWorlds& worlds,
                                                         const ExploreSettings& settings,
                                                         const WalkSpace& reached, double least_area,
                                                         std::size_t most) {
    const collision::Aabb& region = settings.within.empty() ? worlds[0].bounds() : settings.within;
    auto surfaces = unreached_surfaces(worlds, settings, reached, region, most);
    if (!surfaces) {
        return std::nullopt;
    }
    if (settings.keep_out) {
        std::erase_if(*surfaces, [&](const Surface& surface) {
            Vec3 foot = reached.grid.center(surface.cell);
            foot.y() = surface.y;
            return settings.keep_out(foot);
        });
    }
    const std::vector<UnreachedSpot> spots = spots_with_room(worlds, settings, reached, *std::move(surfaces));
    SpotJoiner joiner(worlds, settings, reached.grid, spots);
    return islands_of(spots, joiner.sets(), reached.grid, least_area);
}

std::vector<Island> islands_of(const std::vector<UnreachedSpot>& spots, collision::DisjointSets& sets,
                               const WalkGrid& grid, double least_area) {
    std::map<std::size_t, std::size_t> sizes;
    for (std::size_t i = 0; i < spots.size(); ++i) {
        ++sizes[sets.root(i)];
    }
    std::map<std::size_t, Island> by_root;
    for (const auto& [root, size] : sizes) {
        by_root[root].spots.reserve(size);
    }
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
