#include "engine/walkspace/unreached_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "collision/mesh/mesh_collider.h"
#include "collision/world/obstacle.h"
#include "collision/world/placement.h"
#include "engine/walkspace/disjoint_sets.h"
#include "engine/walkspace/worker_threads.h"

namespace campuswalk::engine {

using collision::ObjectId;
using collision::Vec3;

namespace {

/// Ground this near a reached node, in its cell, is the node's.
constexpr double kSameGround = 0.3;
/// Surfaces this near each other in one cell are one: a carpet on a floor.
constexpr double kOneSurface = 0.02;
/// A round body rests this much higher on a slope of 50 degrees, as a share of its radius, and less on
/// others.
constexpr double kRiseOnSlope = 0.56;

/// A surface at the middle of a cell.
struct Surface {
    GridCell cell;
    double y = 0.0;
    ObjectId object{};
    std::uint32_t triangle = 0;
};

/// Finds the surfaces of one triangle after another.
class SurfaceCollector {
public:
    SurfaceCollector(const ExploreSettings& settings, const WalkSpace& reached, std::vector<Surface>& out)
        : settings_(settings), reached_(reached), out_(out) {}

    void add(ObjectId object, std::uint32_t index, const std::array<Vec3, 3>& t) {
        const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
        const double length = normal.norm();
        if (!(std::abs(normal.y()) >= settings_.strides.body.min_up * length) || length <= 0.0) {
            return;
        }
        const WalkGrid& grid = reached_.grid;
        const auto [x0, x1] = std::minmax({t[0].x(), t[1].x(), t[2].x()});
        const auto [z0, z1] = std::minmax({t[0].z(), t[1].z(), t[2].z()});
        const GridCell first = grid.cell_at(x0 - 0.5 * grid.cell, z0 - 0.5 * grid.cell);
        const GridCell last = grid.cell_at(x1, z1);
        for (int z = first.z; z <= last.z; ++z) {
            for (int x = first.x; x <= last.x; ++x) {
                const Vec3 p = grid.center({x, z});
                if (is_below(t, p)) {
                    const double y =
                        t[0].y() -
                        (normal.x() * (p.x() - t[0].x()) + normal.z() * (p.z() - t[0].z())) / normal.y();
                    offer({{x, z}, y, object, index});
                }
            }
        }
    }

private:
    /// Whether the vertical line through p crosses the triangle.
    static bool is_below(const std::array<Vec3, 3>& t, const Vec3& p) {
        int sides = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& a = t[i];
            const Vec3& b = t[(i + 1) % 3];
            const double side = (b.x() - a.x()) * (p.z() - a.z()) - (b.z() - a.z()) * (p.x() - a.x());
            sides += side > 0.0 ? 1 : side < 0.0 ? -1 : 0;
        }
        return std::abs(sides) >= 2;
    }

    void offer(const Surface& surface) {
        if (!reached_.find(surface.cell, surface.y, kSameGround)) {
            out_.push_back(surface);
        }
    }

    const ExploreSettings& settings_;
    const WalkSpace& reached_;
    std::vector<Surface>& out_;
};

void collect(SurfaceCollector& collector, const collision::World& world, ObjectId id) {
    const collision::Object& object = world.object(id);
    const collision::Pose& X = object.X_world_shape;
    if (const auto* mesh = std::get_if<std::shared_ptr<const collision::MeshCollider>>(&object.shape)) {
        const collision::TriangleMesh& shape = (*mesh)->mesh();
        for (std::uint32_t i = 0; i < shape.triangles.size(); ++i) {
            std::array<Vec3, 3> vertices;
            for (std::size_t k = 0; k < 3; ++k) {
                vertices[k] = X * shape.positions[shape.triangles[i][k]].cast<double>();
            }
            collector.add(id, i, vertices);
        }
    } else if (const auto* box = std::get_if<collision::Box>(&object.shape)) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const double side : {-1.0, 1.0}) {
                const auto vertex = [&](double u, double v) {
                    Vec3 p = Vec3::Zero();
                    p[axis] = side;
                    p[(axis + 1) % 3] = u;
                    p[(axis + 2) % 3] = v;
                    return Vec3(X * p.cwiseProduct(box->half_extents));
                };
                collector.add(id, 0, {vertex(-1, -1), vertex(1, -1), vertex(1, 1)});
                collector.add(id, 0, {vertex(-1, -1), vertex(1, 1), vertex(-1, 1)});
            }
        }
    }
}

/// All surfaces without a reached node, by cell from low to high, without those on one another.
std::vector<Surface> unreached_surfaces(const collision::World& world, const ExploreSettings& settings,
                                        const WalkSpace& reached) {
    std::vector<Surface> surfaces;
    SurfaceCollector collector(settings, reached, surfaces);
    std::vector<ObjectId> solids;
    world.candidates(world.bounds(), settings.solids, solids);
    for (const ObjectId id : solids) {
        collect(collector, world, id);
    }
    std::ranges::sort(surfaces, {},
                      [](const Surface& s) { return std::tuple(s.cell, s.y, s.object, s.triangle); });
    const auto same = [](const Surface& a, const Surface& b) {
        return a.cell == b.cell && std::abs(a.y - b.y) <= kOneSurface;
    };
    surfaces.erase(std::unique(surfaces.begin(), surfaces.end(), same), surfaces.end());
    return surfaces;
}

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
        const double min_up = settings.strides.body.min_up;
        slope_ = std::max(step_, std::sqrt(1.0 - min_up * min_up) / min_up * grid.cell);
        join_neighbours();
        join_by_steps();
    }

    std::size_t root(std::size_t spot) { return sets_.root(spot); }

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
    DisjointSets sets_;
    Strider strider_;
    double step_;
    double slope_ = 0.0;
    std::map<std::pair<std::size_t, std::size_t>, int> tries_;
};

}  // namespace

std::vector<Island> find_unreached_ground(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                          const WalkSpace& reached, double least_area) {
    const std::vector<Surface> surfaces = unreached_surfaces(worlds[0], settings, reached);
    const std::vector<UnreachedSpot> spots = spots_with_room(worlds, settings, reached, surfaces);
    SpotJoiner joiner(worlds, settings, reached.grid, spots);
    std::map<std::size_t, Island> by_root;
    for (std::size_t i = 0; i < spots.size(); ++i) {
        Island& island = by_root[joiner.root(i)];
        island.spots.push_back(spots[i]);
        island.bounds.extend(spots[i].at.foot);
    }
    std::vector<Island> islands;
    for (auto& [root, island] : by_root) {
        if (island.area(reached.grid) >= least_area) {
            islands.push_back(std::move(island));
        }
    }
    std::ranges::stable_sort(islands, std::greater(), [](const Island& i) { return i.spots.size(); });
    return islands;
}

}  // namespace campuswalk::engine
