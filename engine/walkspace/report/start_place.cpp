#include "engine/walkspace/report/start_place.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "collision/world/cast.h"
#include "collision/world/obstacle.h"
#include "engine/walkspace/explore/unreached_ground.h"
#include "engine/walkspace/explore/unreached_surfaces.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// Coarser than the walk space: any good place will do.
constexpr double kStartCell = 0.5;  // metres
/// On more ground than this, cells are larger, so that there are no more of them.
constexpr double kMostGround = 150'000.0;  // m²
constexpr double kLeastGround = 1.0;       // m²
/// Farther from an edge is no better, cells.
constexpr std::uint32_t kFarEnough = 16;
/// Ground in the next cell that is no higher or lower goes on, metres: as steep as anyone walks.
constexpr double kGoesOn = 0.6;
/// Ground in one cell so much higher is another floor, metres.
constexpr double kNextFloor = 1.0;
/// Where there is more room between two surfaces, it is no room of a building, metres.
constexpr double kHighestRoom = 15.0;

double cell_for(const collision::World& world, const ExploreSettings& settings) {
    const collision::Aabb& region = settings.within.empty() ? world.bounds() : settings.within;
    const std::size_t ground = walkable_surfaces(world, settings, WalkGrid{1.0}, region).size();
    return kStartCell * std::max(1.0, std::sqrt(static_cast<double>(ground) / kMostGround));
}

class IslandGround {
public:
    IslandGround(const Island& island, const WalkGrid& grid) : spots_(island.spots), grid_(grid) {
        for (std::size_t i = 0; i < spots_.size(); ++i) {
            by_cell_[cell_of(i)].push_back(i);
        }
        measure_edge_distances();
    }

    /// In cells, to the nearest spot that hasn't ground on all four sides. Ground on other ground, such as a
    /// carpet, is as far from an edge as that.
    std::uint32_t edge_distance(std::size_t spot) const {
        std::uint32_t least = edge_distances_[spot];
        for (const std::size_t other : by_cell_.at(cell_of(spot))) {
            if (goes_on(spot, other)) {
                least = std::min(least, edge_distances_[other]);
            }
        }
        return least;
    }

private:
    GridCell cell_of(std::size_t spot) const { return grid_.cell_at(spots_[spot].at.foot); }

    bool goes_on(std::size_t a, std::size_t b) const {
        return std::abs(spots_[a].at.foot.y() - spots_[b].at.foot.y()) <= kGoesOn;
    }

    /// On its four sides.
    std::vector<std::size_t> neighbours(std::size_t spot) const {
        std::vector<std::size_t> found;
        const GridCell cell = cell_of(spot);
        for (const auto& [dx, dz] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
            const auto beside = by_cell_.find({cell.x + dx, cell.z + dz});
            if (beside == by_cell_.end()) {
                continue;
            }
            for (const std::size_t other : beside->second) {
                if (goes_on(spot, other)) {
                    found.push_back(other);
                    break;
                }
            }
        }
        return found;
    }

    void measure_edge_distances() {
        constexpr std::uint32_t kUnknown = std::numeric_limits<std::uint32_t>::max();
        edge_distances_.assign(spots_.size(), kUnknown);
        std::queue<std::size_t> open;
        for (std::size_t i = 0; i < spots_.size(); ++i) {
            if (neighbours(i).size() < 4) {
                edge_distances_[i] = 0;
                open.push(i);
            }
        }
        for (; !open.empty(); open.pop()) {
            for (const std::size_t next : neighbours(open.front())) {
                if (edge_distances_[next] == kUnknown) {
                    edge_distances_[next] = edge_distances_[open.front()] + 1;
                    open.push(next);
                }
            }
        }
    }

    const std::vector<UnreachedSpot>& spots_;
    const WalkGrid& grid_;
    std::map<GridCell, std::vector<std::size_t>> by_cell_;
    std::vector<std::uint32_t> edge_distances_;
};

class StartFinder {
public:
    StartFinder(const WorkerWorlds& worlds, const ExploreSettings& settings,
                const StartPreference& preference)
        : world_(worlds[0]),
          settings_(settings),
          preference_(preference),
          grid_{cell_for(worlds[0], settings)} {
        const WalkSpace nothing_reached(grid_);
        islands_ = find_unreached_ground(worlds, settings, nothing_reached, kLeastGround)
                       .value_or(std::vector<Island>());
        for (const Island& island : islands_) {
            for (const UnreachedSpot& spot : island.spots) {
                if (!is_buried(spot.at.foot)) {
                    double& lowest = lowest_.try_emplace(grid_.cell_at(spot.at.foot), 1e300).first->second;
                    lowest = std::min(lowest, spot.at.foot.y());
                }
            }
        }
        spread_lowest();
        for (const Island& island : islands_) {
            is_aside_.push_back(find_aside(island));
        }
    }

    std::vector<StartPlace> best() const {
        constexpr std::size_t kMostStarts = 4;
        std::vector<std::pair<std::size_t, std::size_t>> by_weight;  // and island
        for (std::size_t i = 0; i < islands_.size(); ++i) {
            by_weight.emplace_back(weight_of(i), i);
        }
        std::ranges::stable_sort(by_weight, std::greater(), &std::pair<std::size_t, std::size_t>::first);
        std::vector<StartPlace> places;
        for (const auto& [weight, island] : by_weight) {
            if (places.size() < kMostStarts && 4 * weight >= by_weight.front().first) {
                places.push_back(best_on(island));
            }
        }
        return places;
    }

private:
    /// Compared from the first to the last.
    using Score = std::tuple<bool, bool, bool, std::uint32_t, double>;

    StartPlace best_on(std::size_t island) const {
        const std::vector<UnreachedSpot>& spots = islands_[island].spots;
        const IslandGround ground(islands_[island], grid_);
        std::size_t best = 0;
        Score best_score;
        for (std::size_t i = 0; i < spots.size(); ++i) {
            const Score score = score_of(spots[i].at.foot, is_aside_[island][i], ground.edge_distance(i));
            if (i == 0 || score > best_score) {
                best = i;
                best_score = score;
            }
        }
        return {spots[best].at.foot, is_aside_[island][best], islands_[island].area(grid_)};
    }

    Score score_of(const Vec3& foot, bool is_aside, std::uint32_t edge_distance) const {
        const bool inside = preference_.is_inside && preference_.is_inside(foot);
        return {!is_aside, is_under_the_sky(foot), !inside, std::min(edge_distance, kFarEnough),
                -(foot - preference_.near).squaredNorm()};
    }

    std::size_t weight_of(std::size_t island) const {
        const std::vector<UnreachedSpot>& spots = islands_[island].spots;
        std::size_t weight = 0;
        for (std::size_t i = 0; i < spots.size(); ++i) {
            weight += is_aside_[island][i] ? 1U : is_under_the_sky(spots[i].at.foot) ? 64U : 16U;
        }
        return weight;
    }

    /// Tells for each spot whether it is above other ground, or as high as most of the island that is, such
    /// as the eaves of a roof, or within a block of terrain.
    std::vector<bool> find_aside(const Island& island) const {
        struct Level {
            std::size_t upstairs = 0;
            std::size_t all = 0;
        };
        std::map<int, Level> levels;
        const auto level_of = [&](const UnreachedSpot& spot) -> Level& {
            return levels[static_cast<int>(std::floor(spot.at.foot.y() / kNextFloor))];
        };
        for (const UnreachedSpot& spot : island.spots) {
            ++level_of(spot).all;
            level_of(spot).upstairs += is_upstairs(spot.at.foot) ? 1U : 0U;
        }
        std::vector<bool> aside;
        for (const UnreachedSpot& spot : island.spots) {
            const Level& level = level_of(spot);
            aside.push_back(2 * level.upstairs > level.all || is_upstairs(spot.at.foot) ||
                            is_buried(spot.at.foot));
        }
        return aside;
    }

    /// Ground counts a little beside it, too, also where nobody has room, higher by as much as one walks up:
    /// the top of a wall is above the ground at its foot.
    void spread_lowest() {
        constexpr int kCells = 5;
        const double rise = 1.2 * grid_.cell;
        for (int i = 0; i < kCells; ++i) {
            std::map<GridCell, double> spread = lowest_;
            for (const auto& [cell, height] : lowest_) {
                for (const auto& [dx, dz] :
                     {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
                    double& beside = spread.try_emplace({cell.x + dx, cell.z + dz}, 1e300).first->second;
                    beside = std::min(beside, height + rise);
                }
            }
            lowest_ = std::move(spread);
        }
    }

    bool is_upstairs(const Vec3& foot) const {
        const auto lowest = lowest_.find(grid_.cell_at(foot));
        return (lowest != lowest_.end() && foot.y() - lowest->second > kNextFloor) || has_room_below(foot);
    }

    /// Whether there is a room's height between two surfaces below, as below a roof, whatever stands in the
    /// room.
    bool has_room_below(const Vec3& foot) const {
        constexpr double kSkin = 0.05;    // metres
        constexpr double kOn = 0.25;      // metres below a surface, where a ray goes on
        constexpr int kMostSurfaces = 5;  // of a roof
        const Vec3 bottom = foot - kHighestRoom * Vec3::UnitY();
        Vec3 from = foot - kSkin * Vec3::UnitY();
        for (int i = 0; i < kMostSurfaces; ++i) {
            const auto hit =
                collision::cast(world_, settings_.solids, {from, bottom}, collision::Detection::solid);
            if (!hit) {
                return false;
            }
            const double gap = hit->fraction * (from.y() - bottom.y());
            if (gap >= settings_.strides.body.height) {
                return true;
            }
            from.y() -= gap + kOn;
        }
        return false;
    }

    /// Whether the place is within a block of terrain: below the back of what faces up, which is higher above
    /// than a roof.
    bool is_buried(const Vec3& foot) const {
        constexpr double kNear = 0.05;  // metres
        constexpr double kUp = 0.3;     // of the normal
        const Vec3 sky(foot.x(), std::max(world_.bounds().max.y(), foot.y()) + 1.0, foot.z());
        const Vec3 start = foot + settings_.strides.body.height * Vec3::UnitY();
        const auto hit = collision::cast(world_, settings_.solids, {start, sky}, collision::Detection::solid);
        const Vec3 above = hit ? Vec3(start + hit->fraction * (sky - start)) : foot;
        if (above.y() - foot.y() < kHighestRoom) {
            return false;
        }
        std::vector<collision::Obstacle> pieces;
        collision::gather_obstacles(world_, settings_.solids, {above, above}, kNear, pieces);
        return std::ranges::all_of(pieces, [](const collision::Obstacle& each) {
            return each.solid == nullptr && each.normal.y() > kUp;
        });
    }

    bool is_under_the_sky(const Vec3& foot) const {
        const Vec3 eye = foot + Vec3(0, settings_.strides.body.height, 0);
        const Vec3 sky(eye.x(), std::max(world_.bounds().max.y(), eye.y()) + 1.0, eye.z());
        return !collision::cast(world_, settings_.solids, {eye, sky}, collision::Detection::solid);
    }

    const collision::World& world_;
    const ExploreSettings& settings_;
    const StartPreference& preference_;
    const WalkGrid grid_;
    std::vector<Island> islands_;
    std::map<GridCell, double> lowest_;        ///< by cell: the lowest ground there and near it
    std::vector<std::vector<bool>> is_aside_;  ///< by island and spot: see find_aside
};

}  // namespace

std::vector<StartPlace> best_starts(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                    const StartPreference& preference) {
    return StartFinder(worlds, settings, preference).best();
}

}  // namespace campuswalk::engine
