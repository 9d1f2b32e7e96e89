#include "engine/walkspace/explore/unreached_surfaces.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>
#include <variant>

#include "collision/mesh/mesh_query.h"
#include "engine/walkspace/stride/worker_threads.h"

namespace campuswalk::engine {

using collision::ObjectId;
using collision::Vec3;

namespace {

/// Ground this near a reached node, in its cell, is the node's.
constexpr double kSameGround = 0.3;
/// Surfaces this near each other in one cell are one: a carpet on a floor.
constexpr double kOneSurface = 0.02;
/// They are collected in squares of so many cells, as most of them are reached ones; larger squares where
/// there would be more than so many of them side by side.
constexpr int kSquare = 64;
constexpr int kMostSquares = 256;

/// Cells are numbered so far from the origin, metres; nobody walks there.
constexpr double kFarthest = 1e8;
/// Of a cell's edge: points at which surfaces that stick out from under others are looked for.
constexpr double kCloser = 3.0;

/// By cell from low to high. An object, so that it is inlined where surfaces are sorted.
constexpr auto kInOrder = [](const Surface& a, const Surface& b) {
    if (a.cell != b.cell) {
        return a.cell < b.cell;
    }
    return std::tie(a.y, a.object, a.triangle) < std::tie(b.y, b.object, b.triangle);
};

/// By kInOrder. Most cells of a square have one surface or a few: once these are together, there is hardly
/// anything left to compare.
void sort_in_order(std::vector<Surface>& surfaces) {
    GridCell low{std::numeric_limits<int>::max(), std::numeric_limits<int>::max()};
    GridCell high{std::numeric_limits<int>::min(), std::numeric_limits<int>::min()};
    for (const Surface& surface : surfaces) {
        low = {std::min(low.x, surface.cell.x), std::min(low.z, surface.cell.z)};
        high = {std::max(high.x, surface.cell.x), std::max(high.z, surface.cell.z)};
    }
    constexpr std::size_t kSparse = 4;  // cells for each surface
    const auto side = [](int first, int last) {
        return static_cast<std::size_t>(std::int64_t{last} - std::int64_t{first}) + 1;
    };
    if (surfaces.empty() || side(low.x, high.x) * side(low.z, high.z) > kSparse * surfaces.size()) {
        std::ranges::sort(surfaces, kInOrder);
        return;
    }
    const auto number_of = [&](const GridCell& cell) {
        return static_cast<std::size_t>(cell.x - low.x) * side(low.z, high.z) +
               static_cast<std::size_t>(cell.z - low.z);
    };
    std::vector<std::uint32_t> ends(side(low.x, high.x) * side(low.z, high.z), 0);
    for (const Surface& surface : surfaces) {
        ++ends[number_of(surface.cell)];
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<Surface> sorted(surfaces.size());
    for (const Surface& surface : surfaces) {
        sorted[--ends[number_of(surface.cell)]] = surface;  // from here on: where each cell's begin
    }
    for (std::size_t cell = 0; cell < ends.size(); ++cell) {
        const std::size_t end = cell + 1 < ends.size() ? ends[cell + 1] : sorted.size();
        if (end - ends[cell] > 1) {
            std::ranges::sort(std::span(sorted).subspan(ends[cell], end - ends[cell]), kInOrder);
        }
    }
    surfaces = std::move(sorted);
}

/// Finds the surfaces of one triangle after another.
class SurfaceCollector {
public:
    SurfaceCollector(const ExploreSettings& settings, const WalkGrid& grid, const collision::Aabb& region,
                     std::size_t most, std::vector<Surface>& out)
        : settings_(settings), grid_(grid), region_(region), most_(most), out_(out) {}

    void add(ObjectId object, std::uint32_t index, const std::array<Vec3, 3>& t) {
        const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
        const double length = normal.norm();
        if (!(std::abs(normal.y()) >= settings_.strides.body.min_up * length) || length <= 0.0) {
            return;
        }
        const Vec3 low = t[0].cwiseMin(t[1]).cwiseMin(t[2]).cwiseMax(region_.min);
        const Vec3 high = t[0].cwiseMax(t[1]).cwiseMax(t[2]).cwiseMin(region_.max);
        const GridCell first = grid_.cell_at(low.x() - 0.5 * grid_.cell, low.z() - 0.5 * grid_.cell);
        const GridCell last = grid_.cell_at(high);
        for (int z = first.z; z <= last.z && out_.size() <= most_; ++z) {
            const auto [left, right] = columns_in_row(t, z, first.x, last.x);
            for (int x = left; x <= right && out_.size() <= most_; ++x) {
                const Vec3 p = grid_.center({x, z});
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
    /// The cells from `first` to `last` of a row that the triangle may be above or below. A long one that
    /// lies askew has hardly any of those around it.
    std::pair<int, int> columns_in_row(const std::array<Vec3, 3>& t, int z, int first, int last) const {
        constexpr int kFew = 16;
        if (last - first <= kFew) {
            return {first, last};
        }
        const double near = grid_.center({first, z}).z() - grid_.cell;
        const double far = near + 2.0 * grid_.cell;
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& a = t[i].z() < t[(i + 1) % 3].z() ? t[i] : t[(i + 1) % 3];
            const Vec3& b = t[i].z() < t[(i + 1) % 3].z() ? t[(i + 1) % 3] : t[i];
            if (b.z() < near || a.z() > far) {
                continue;
            }
            for (const double at : {std::max(near, a.z()), std::min(far, b.z())}) {
                const double share = b.z() > a.z() ? (at - a.z()) / (b.z() - a.z()) : 0.0;
                low = std::min({low, a.x() + share * (b.x() - a.x()), b.z() > a.z() ? low : b.x()});
                high = std::max({high, a.x() + share * (b.x() - a.x()), b.z() > a.z() ? high : b.x()});
            }
        }
        if (!(low <= high)) {
            return {first, first - 1};
        }
        const double x0 = grid_.center({first, z}).x();
        const auto column = [&](double x, int beside) {
            return first + beside +
                   static_cast<int>(std::clamp(std::floor((x - x0) / grid_.cell), -2.0, last - first + 2.0));
        };
        return {std::max(first, column(low, -1)), std::min(last, column(high, 2))};
    }

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
        if (surface.y >= region_.min.y() && surface.y <= region_.max.y()) {
            out_.push_back(surface);
        }
    }

    const ExploreSettings& settings_;
    const WalkGrid& grid_;
    const collision::Aabb& region_;
    std::size_t most_;
    std::vector<Surface>& out_;
};

void collect(SurfaceCollector& collector, const collision::World& world, ObjectId id,
             const collision::Aabb& region) {
    const collision::Object& object = world.object(id);
    const collision::Pose& X = object.X_world_shape;
    if (const auto* mesh = std::get_if<std::shared_ptr<const collision::MeshCollider>>(&object.shape)) {
        const auto add = [&](std::uint32_t i, const collision::Triangle& t) {
            collector.add(id, i, {X * t.a, X * t.b, X * t.c});
        };
        collision::visit_triangles_beyond(**mesh, X, collision::Aabb{}, region, add);
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

/// Whether another surface lies so close above that no body has room between them: it takes up its height
/// less its radius twice above what it touches, however far it hangs over an edge. `surfaces`: in order.
bool is_covered(std::span<const Surface> surfaces, std::size_t i, double room) {
    return i + 1 < surfaces.size() && surfaces[i + 1].cell == surfaces[i].cell &&
           surfaces[i + 1].y - surfaces[i].y < room;
}

/// Tells which surfaces of a square no body touches. They are in order, and asked about in that order.
class Covers {
public:
    Covers(const collision::World& world, const ExploreSettings& settings, const WalkGrid& grid,
           std::span<const Surface> surfaces)
        : world_(world), settings_(settings), grid_(grid), surfaces_(surfaces) {}

    static double room(const ExploreSettings& settings) {
        return settings.strides.body.height - 2.0 * settings.strides.body.radius;
    }

    /// Whether the surface is covered, and doesn't stick out from under what covers it beside its cell's
    /// middle.
    bool is_untouchable(std::size_t i) {
        if (!is_covered(surfaces_, i, room_)) {
            return false;
        }
        const auto is_covered_beside = [&](const GridDirection& side) {
            return has_cover_beside(surfaces_[i], side);
        };
        return std::all_of(grid_directions().begin(), grid_directions().end(), is_covered_beside) ||
               !sticks_out(surfaces_[i]);
    }

private:
    bool has_cover_beside(const Surface& surface, const GridDirection& side) {
        const GridCell beside{surface.cell.x + side.x, surface.cell.z + side.z};
        std::size_t above = first_in_row(surface.cell, side.x);
        while (above < surfaces_.size() &&
               (surfaces_[above].cell < beside ||
                (surfaces_[above].cell == beside && surfaces_[above].y <= surface.y + kOneSurface))) {
            ++above;
        }
        return above < surfaces_.size() && surfaces_[above].cell == beside &&
               surfaces_[above].y < surface.y + room_;
    }

    /// The first surface in the row beside the cell, or in its own, that is at most one cell before it.
    std::size_t first_in_row(const GridCell& cell, int side) {
        const int row = side + 1;
        std::size_t& first = first_in_row_[static_cast<std::size_t>(row)];
        const GridCell lowest{cell.x + side, cell.z - 1};
        while (first < surfaces_.size() && surfaces_[first].cell < lowest) {
            ++first;
        }
        return first;
    }

    /// At closer points in and around its cell.
    bool sticks_out(const Surface& surface) const {
        const WalkGrid finer{grid_.cell / kCloser};
        const Vec3 reach(grid_.cell, 0.0, grid_.cell);  // farther off, a cell's middle would be on it
        Vec3 low = grid_.center(surface.cell) - reach;
        Vec3 high = grid_.center(surface.cell) + reach;
        low.y() = surface.y - kSameGround;
        high.y() = surface.y + kSameGround + room_;
        const std::vector<Surface> near = walkable_surfaces(world_, settings_, finer, {low, high});
        const auto apart = [&](const Surface& there) { return std::abs(there.y - surface.y); };
        for (std::size_t i = 0, end = 0; i < near.size(); i = end) {
            std::size_t nearest = i;
            for (end = i + 1; end < near.size() && near[end].cell == near[i].cell; ++end) {
                nearest = apart(near[end]) < apart(near[nearest]) ? end : nearest;
            }
            if (apart(near[nearest]) <= kSameGround && !is_covered(near, nearest, room_)) {
                return true;
            }
        }
        return false;
    }

    const collision::World& world_;
    const ExploreSettings& settings_;
    const WalkGrid& grid_;
    std::span<const Surface> surfaces_;
    double room_ = room(settings_);
    std::array<std::size_t, 3> first_in_row_{};  ///< for the last cell asked about: earlier ones are behind
};

/// The surfaces in a square of `side` x `side` cells that begins with this one, as far as it lies in the
/// region. None if more than `most` surfaces are there, reached or not.
std::optional<std::vector<Surface>> unreached_in_square(const collision::World& world,
                                                        const ExploreSettings& settings,
                                                        const WalkSpace& reached,
                                                        const collision::Aabb& region, const GridCell& square,
                                                        int side, std::size_t most) {
    const double cell = reached.grid.cell;
    const Vec3 low(square.x * cell, region.min.y(), square.z * cell);
    const Vec3 high = low + side * cell * Vec3::Ones();
    collision::Aabb part{low.cwiseMax(region.min), high.cwiseMin(region.max)};
    part.max.y() = region.max.y() + Covers::room(settings);
    const std::vector<Surface> all = walkable_surfaces(world, settings, reached.grid, part, most);
    if (all.size() > most) {
        return std::nullopt;
    }
    Covers covers(world, settings, reached.grid, all);
    std::vector<Surface> unreached;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (first_of_square(all[i].cell, side) == square && all[i].y <= region.max.y() &&
            !reached.find(all[i].cell, all[i].y, kSameGround) && !covers.is_untouchable(i)) {
            unreached.push_back(all[i]);
        }
    }
    return unreached;
}

}  // namespace

std::vector<Surface> walkable_surfaces(const collision::World& world, const ExploreSettings& settings,
                                       const WalkGrid& grid, const collision::Aabb& region,
                                       std::size_t most) {
    std::vector<Surface> surfaces;
    SurfaceCollector collector(settings, grid, region, most, surfaces);
    std::vector<ObjectId> solids;
    world.candidates(region, settings.solids, solids);
    for (const ObjectId id : solids) {
        collect(collector, world, id, region);
    }
    sort_in_order(surfaces);
    const auto same = [](const Surface& a, const Surface& b) {
        return a.cell == b.cell && std::abs(a.y - b.y) <= kOneSurface;
    };
    surfaces.erase(std::unique(surfaces.begin(), surfaces.end(), same), surfaces.end());
    return surfaces;
}

std::optional<std::vector<Surface>> unreached_surfaces(const WorkerWorlds& worlds,
                                                       const ExploreSettings& settings,
                                                       const WalkSpace& reached,
                                                       const collision::Aabb& region, std::size_t most) {
    if (region.empty()) {
        return std::vector<Surface>();
    }
    const GridCell lowest = reached.grid.cell_at(region.min.cwiseMax(-kFarthest));
    const GridCell last = reached.grid.cell_at(region.max.cwiseMin(kFarthest));
    const int longest = std::max(last.x - lowest.x, last.z - lowest.z);
    const int side = std::max(kSquare, longest / kMostSquares + 1);
    const GridCell first = first_of_square(lowest, side);
    std::vector<GridCell> squares;
    for (int x = first.x; x <= last.x; x += side) {
        for (int z = first.z; z <= last.z; z += side) {
            squares.push_back({x, z});
        }
    }
    std::vector<std::vector<Surface>> found(squares.size());
    std::atomic<std::size_t> count = 0;  // ends above `most` in whatever order squares are taken, or in none
    for_each_item(squares.size(), worlds.size(), [&](std::size_t worker, std::size_t i) {
        if (count > most) {
            return;
        }
        auto surfaces =
            unreached_in_square(worlds[worker], settings, reached, region, squares[i], side, most);
        count += surfaces ? surfaces->size() : most + 1;
        found[i] = std::move(surfaces).value_or(std::vector<Surface>());
    });
    if (count > most) {
        return std::nullopt;
    }
    std::vector<Surface> unreached;
    unreached.reserve(count);
    for (std::vector<Surface>& surfaces : found) {
        unreached.insert(unreached.end(), surfaces.begin(), surfaces.end());
        surfaces = {};
    }
    std::ranges::sort(unreached, kInOrder);
    return unreached;
}

}  // namespace campuswalk::engine
