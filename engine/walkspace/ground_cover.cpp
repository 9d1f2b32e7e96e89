#include "engine/walkspace/ground_cover.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <variant>
#include <vector>

#include "collision/mesh/mesh_collider.h"
#include "collision/world/cast.h"
#include "engine/script/avatar_body.h"
#include "engine/walkspace/explore.h"
#include "engine/walkspace/node_numbers.h"
#include "engine/walkspace/unreached_ground.h"

namespace campuswalk::engine {

using collision::Aabb;
using collision::Vec3;

namespace {

/// Coarser than the walk space; its diagonal is a little less than the body's width. Metres.
constexpr double kGroundCell = 0.42;
/// More isn't explored than this share of the footprint, of small ones this much, of large ones that much,
/// m².
constexpr double kLeastEnough = 50.0;
constexpr double kEnoughGround = 500.0;
constexpr double kEnoughShare = 0.4;
/// From so many places at most.
constexpr std::size_t kMostPlaces = 6;
/// Places are looked for in so many columns, at least a metre wide.
constexpr double kColumns = 2'500.0;
constexpr double kSurfaces = 20'000.0;

ExploreSettings settings_for_lint() {
    const AvatarProfile avatar;
    ExploreSettings settings;
    settings.strides.body = mover_settings(avatar);
    settings.strides.walk_speed = avatar.speed;
    settings.strides.seconds = 1.0 / 60.0;
    settings.solids = {collision::Detection::solid, 0, nullptr};
    settings.cell = kGroundCell;
    settings.steer_falls = false;
    // None: but when it looks for a goal it explores in short rounds, and stops soon after the most nodes.
    settings.is_goal = [](const GridCell&, double) { return false; };
    return settings;
}

/// Calls `visit` for the triangles of the world's meshes.
template <typename Visit>
void visit_triangles(const collision::World& world, const Visit& visit) {
    for (std::size_t i = 0; i < world.size(); ++i) {
        const collision::Object& object = world.object(static_cast<collision::ObjectId>(i));
        const auto* shape = std::get_if<std::shared_ptr<const collision::MeshCollider>>(&object.shape);
        const std::size_t triangles = shape == nullptr ? 0 : (*shape)->mesh().triangles.size();
        for (std::uint32_t t = 0; t < triangles; ++t) {
            const collision::Triangle own = collision::vertices((*shape)->mesh(), t);
            const collision::Pose& X = object.X_world_shape;
            visit(Vec3(X * own.a), Vec3(X * own.b), Vec3(X * own.c));
        }
    }
}

/// So wide that there are no more columns, and no more surfaces in them where these lie above one another.
double column_width(const collision::World& world) {
    double boxes = 0.0;  // seen from above
    visit_triangles(world, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 size = a.cwiseMax(b).cwiseMax(c) - a.cwiseMin(b).cwiseMin(c);
        boxes += size.x() * size.z();
    });
    const Vec3 size = world.bounds().max - world.bounds().min;
    return std::max({1.0, std::sqrt(size.x() * size.z() / kColumns), size.x() / kColumns, size.z() / kColumns,
                     std::sqrt(boxes / kSurfaces)});
}

/// The area of the columns in which there is anything.
double footprint(const collision::World& world, const collision::QueryFilter& solids) {
    const Aabb& bounds = world.bounds();
    const WalkGrid grid{0.5 * column_width(world)};
    const GridCell last = grid.cell_at(bounds.max);
    double area = 0.0;
    for (GridCell cell = grid.cell_at(bounds.min); cell.z <= last.z; ++cell.z) {
        for (cell.x = grid.cell_at(bounds.min).x; cell.x <= last.x; ++cell.x) {
            const Vec3 middle = grid.center(cell);
            const Vec3 top(middle.x(), bounds.max.y() + 1.0, middle.z());
            const Vec3 bottom(middle.x(), bounds.min.y() - 1.0, middle.z());
            const bool any = cast(world, solids, {top, bottom}, collision::Detection::solid).has_value();
            area += any ? grid.cell * grid.cell : 0.0;
        }
    }
    return area;
}

double share_of_area_below(const collision::World& world, double height) {
    double below = 0.0;
    double all = 0.0;
    visit_triangles(world, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        const double area = (b - a).cross(c - a).norm();
        all += area;
        below += (a.y() + b.y() + c.y()) / 3.0 < height ? area : 0.0;
    });
    return all > 0.0 ? below / all : 0.0;
}

/// Of the nodes that have ground on all four sides: not on top of a wall, nor over an edge.
std::vector<double> inner_heights(const WalkSpace& space) {
    constexpr double kSteepest = 1.2;  // metres up per metre
    const double apart = kSteepest * space.grid.cell;
    std::vector<double> heights;
    NodeNumbers(space).for_each([&](const WalkNodeId& id) {
        const GridCell cell = space.cell_of(id);
        const auto y = static_cast<double>(space.node(id).y);
        const auto has = [&](int x, int z) {
            const auto beside = space.find({cell.x + x, cell.z + z}, y, apart);
            return beside && space.node(*beside).hangs == 0;
        };
        if (space.node(id).hangs == 0 && has(1, 0) && has(-1, 0) && has(0, 1) && has(0, -1)) {
            heights.push_back(y);
        }
    });
    return heights;
}

GroundCover cover_of(const collision::World& world, const WalkSpace& space, double footprint) {
    constexpr double kDrop =
        1.05;  // metres: a metre below the ground, on which the feet rest a little higher
    std::vector<double> heights = inner_heights(space);
    if (heights.empty()) {
        return {};
    }
    const auto low = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 20);
    std::ranges::nth_element(heights, low);
    GroundCover cover;
    cover.area = static_cast<double>(heights.size()) * space.grid.cell * space.grid.cell;
    cover.is_bounded = std::ranges::find(space.bounds, Bound::nodes) != space.bounds.end();
    cover.share = footprint > 0.0 ? std::min(cover.area / footprint, 1.0) : 0.0;
    cover.height = *low;
    cover.share_below = share_of_area_below(world, cover.height - kDrop);
    return cover;
}

/// A low spot: rather on the floor than on a table.
Vec3 start_on(const Island& island) {
    std::vector<UnreachedSpot> spots = island.spots;
    const auto low = spots.begin() + static_cast<std::ptrdiff_t>(spots.size() / 10);
    std::ranges::nth_element(spots, low, {}, [](const UnreachedSpot& spot) { return spot.at.foot.y(); });
    return low->at.foot;
}

}  // namespace

GroundCover measure_ground(const WorkerWorlds& worlds) {
    const collision::World& world = worlds[0];
    ExploreSettings settings = settings_for_lint();
    const WalkSpace columns(WalkGrid{column_width(world)});
    const double all = footprint(world, settings.solids);
    const double enough = std::clamp(kEnoughShare * all, kLeastEnough, kEnoughGround);
    settings.max_nodes = static_cast<std::size_t>(enough / (settings.cell * settings.cell));
    GroundCover largest;
    std::size_t tried = 0;
    for (const Island& island : find_unreached_ground(worlds, settings, columns, 0.0)) {
        if (largest.is_bounded || largest.area > island.area(columns.grid) || ++tried > kMostPlaces) {
            break;
        }
        settings.starts = {start_on(island)};
        const WalkSpace space = explore(worlds, settings);
        const GroundCover cover = cover_of(world, space, all);
        largest = cover.area > largest.area ? cover : largest;
    }
    return largest;
}

bool lacks_ground(const GroundCover& cover) {
    constexpr double kMinShare = 0.25;
    const bool is_large = cover.is_bounded && cover.area > 0.5 * kEnoughGround;
    return (cover.share < kMinShare && !is_large) || is_roof(cover);
}

bool is_roof(const GroundCover& cover) {
    constexpr double kMaxShareBelow = 0.3;
    return cover.share_below > kMaxShareBelow;
}

}  // namespace campuswalk::engine
