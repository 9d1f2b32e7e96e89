#include "engine/walkspace/report/ground_cover.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "collision/world/cast.h"
#include "engine/script/avatar_body.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/explore/unreached_ground.h"
#include "engine/walkspace/report/triangle_density.h"
#include "engine/walkspace/space/node_numbers.h"

namespace campuswalk::engine {

using collision::Aabb;
using collision::Vec3;

namespace {

/// Coarser than the walk space; its diagonal is a little less than the body's width. Metres.
constexpr double kGroundCell = 0.42;
/// More isn't explored than this share of the footprint, of small ones this much, of large ones that much,
/// m².
constexpr double kLeastEnough = 50.0;
constexpr double kEnoughGround = 250.0;
constexpr double kEnoughShare = 0.4;
/// From so many places at most: rooms behind closed doors.
constexpr std::size_t kMostPlaces = 64;
/// Nodes, each times the triangles near it: a stride among many is slow, as the mover looks at them in every
/// tick. A quarter of a second.
constexpr double kMostWork = 150'000.0;
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
    settings.grid = WalkGrid{kGroundCell};
    settings.steer_falls = false;
    return settings;
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

/// Without what faces down: a block of terrain has a bottom as large as its top.
double share_of_area_below(const collision::World& world, double height) {
    constexpr double kDown = -0.7;  // of the normal
    double below = 0.0;
    double all = 0.0;
    visit_triangles(world, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 normal = (b - a).cross(c - a);
        const double area = normal.norm();
        if (normal.y() < kDown * area) {
            return;
        }
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

/// Of ground all of which is an edge, `height` is the height.
GroundCover cover_of(const collision::World& world, const WalkSpace& space, double footprint, double height) {
    constexpr double kDrop = 2.05;  // metres: as far below as a floor is, for feet that rest a little higher
    std::vector<double> heights = inner_heights(space);
    GroundCover cover;
    cover.height = height;
    if (!heights.empty()) {
        const auto low = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 20);
        std::ranges::nth_element(heights, low);
        cover.height = *low;
    }
    cover.area = static_cast<double>(heights.size()) * space.grid.cell * space.grid.cell;
    cover.is_cut_short = space.is_cut_by(Bound::nodes);
    cover.share = footprint > 0.0 ? std::min(cover.area / footprint, 1.0) : 0.0;
    cover.share_below = share_of_area_below(world, cover.height - kDrop);
    return cover;
}

/// Walks about on one piece of ground after another, and adds up what isn't a roof.
class GroundSurvey {
public:
    explicit GroundSurvey(const WorkerWorlds& worlds)
        : worlds_(worlds),
          settings_(settings_for_lint()),
          columns_(WalkGrid{column_width(worlds[0])}),
          footprint_(footprint(worlds[0], settings_.solids)),
          density_(worlds[0]) {
        const double enough = std::clamp(kEnoughShare * footprint_, kLeastEnough, kEnoughGround);
        nodes_left_ = enough / cell_area();
        settings_.keep_out = [this](const Vec3& foot) { return is_crowded(foot) || is_walked(foot); };
    }

    GroundCover largest() {
        auto islands = find_unreached_ground(worlds_, settings_, columns_, 0.0);
        for (Island& island : islands.value()) {  // there are fewer columns than are looked for
            while (is_wanted() && walk_about(island)) {
            }
        }
        return lacks_ground(ground_) && roof_.share > ground_.share ? roof_ : ground_;
    }

private:
    bool is_wanted() const {
        return lacks_ground(ground_) && nodes_left_ >= 1.0 && walked_.size() < kMostPlaces;
    }

    static double cell_area() { return kGroundCell * kGroundCell; }

    bool is_crowded(const Vec3& foot) const { return is_limited_ && density_.around(foot) > most_triangles_; }

    bool is_walked(const Vec3& foot) const {
        return std::ranges::any_of(walked_, [&](const WalkSpace& space) {
            return space.find(space.grid.cell_at(foot), foot.y()).has_value();
        });
    }

    /// What looks like one piece may be several rooms. False if there is nothing left of it.
    bool walk_about(Island& island) {
        std::erase_if(island.spots, [this](const UnreachedSpot& spot) { return is_walked(spot.at.foot); });
        if (island.spots.empty()) {
            return false;
        }
        const std::size_t affordable = limit_work(island);
        const double area = island.area(columns_.grid);
        const Vec3 start = take_start(island);
        settings_.starts = {start};
        settings_.max_nodes = is_limited_ ? affordable : static_cast<std::size_t>(nodes_left_);
        // No cell is the goal, but looking for one keeps rounds short, so that it stops soon after the most
        // nodes.
        const UntilCell goal{[](const GridCell&, double) { return false; }};
        WalkSpace space =
            settings_.max_nodes > 0 ? explore(worlds_, settings_, goal) : WalkSpace(WalkGrid{kGroundCell});
        GroundCover cover = cover_of(worlds_[0], space, footprint_, start.y());
        if (is_limited_) {  // then the columns tell how much there would have been
            cover.is_cut_short = true;
            cover.share = std::clamp(area / footprint_, cover.share, 1.0);
        }
        cover.seen = cover.is_cut_short ? std::max(area, cover.area) : cover.area;
        add(cover);
        nodes_left_ -= is_roof(cover) ? 0.0 : static_cast<double>(space.node_count());
        work_left_ -= work_of(space);
        walked_.push_back(std::move(space));
        return !is_limited_;
    }

    /// Keeps out of where most triangles are, as far as need be to walk about on the rest. Returns how many
    /// nodes that allows.
    std::size_t limit_work(const Island& island) {
        std::vector<double> triangles;
        for (const UnreachedSpot& spot : island.spots) {
            triangles.push_back(density_.around(spot.at.foot));
        }
        std::ranges::sort(triangles);
        const double nodes_of_spot = columns_.grid.cell * columns_.grid.cell / cell_area();
        std::size_t count = 0;
        double nodes = 0.0;
        for (double sum = 0.0; count < triangles.size(); ++count) {
            sum += triangles[count];
            const auto spots = static_cast<double>(count + 1);
            const double wanted = std::min(nodes_left_, nodes_of_spot * spots);
            if (wanted * sum / spots > work_left_) {
                break;
            }
            nodes = wanted;
        }
        is_limited_ = count < triangles.size();
        most_triangles_ = count > 0 ? triangles[count - 1] : -1.0;
        return static_cast<std::size_t>(nodes);
    }

    double work_of(const WalkSpace& space) const {
        double work = 0.0;
        NodeNumbers(space).for_each(
            [&](const WalkNodeId& id) { work += density_.around(space.position(id)); });
        return work;
    }

    /// A low spot, rather on the floor than on a table, if possible where there aren't too many triangles.
    Vec3 take_start(Island& island) const {
        auto& spots = island.spots;
        const auto crowded =
            std::stable_partition(spots.begin(), spots.end(),
                                  [this](const UnreachedSpot& spot) { return !is_crowded(spot.at.foot); });
        const auto end = crowded == spots.begin() ? spots.end() : crowded;
        const auto low = spots.begin() + (end - spots.begin()) / 10;
        std::ranges::nth_element(spots.begin(), low, end, {},
                                 [](const UnreachedSpot& spot) { return spot.at.foot.y(); });
        Vec3 start = low->at.foot;
        spots.erase(low);
        return start;
    }

    void add(const GroundCover& cover) {
        if (is_roof(cover)) {
            roof_ = cover.share > roof_.share ? cover : roof_;
        } else if (ground_.share == 0.0) {
            ground_ = cover;
        } else {
            ground_.area += cover.area;
            ground_.seen += cover.seen;
            ground_.share = std::min(1.0, ground_.share + cover.share);
            ground_.is_cut_short = ground_.is_cut_short || cover.is_cut_short;
        }
    }

    const WorkerWorlds& worlds_;
    ExploreSettings settings_;
    const WalkSpace columns_;
    const double footprint_;
    const TriangleDensity density_;
    double nodes_left_ = 0.0;
    double work_left_ = kMostWork;
    bool is_limited_ = false;      ///< by work, on this piece
    double most_triangles_ = 0.0;  ///< then: near a place, for it to be walked to
    std::vector<WalkSpace> walked_;
    GroundCover ground_;  ///< the sum of all but roofs, with the height of the first
    GroundCover roof_;    ///< the largest
};

}  // namespace

GroundCover measure_ground(const WorkerWorlds& worlds) {
    return GroundSurvey(worlds).largest();
}

bool lacks_ground(const GroundCover& cover) {
    constexpr double kMinShare = 0.25;
    const bool is_large = cover.is_cut_short && cover.area > 0.5 * kEnoughGround;
    return (cover.share < kMinShare && !is_large) || is_roof(cover);
}

bool is_roof(const GroundCover& cover) {
    constexpr double kMaxShareBelow = 0.3;
    return cover.share_below > kMaxShareBelow;
}

}  // namespace campuswalk::engine
