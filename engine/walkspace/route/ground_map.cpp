#include "engine/walkspace/route/ground_map.h"

#include <algorithm>

#include "collision/world/placement.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/explore/unreached_surfaces.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// Where in a cell the body is tried, in thirds of it from the middle: a passage that is 10 cm wider than the
/// body has room for one of them in each of its cells.
constexpr std::uint8_t kPointCount = 9;
constexpr std::array<std::array<int, 2>, kPointCount> kPoints{
    {{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

/// Nobody stands on a surface that lies so little below another, metres: the ground under a pavement.
constexpr float kCovered = 0.3F;

/// What lies lower above the ground is nothing that sweeps care for, metres: slopes, bumps, and for bodies
/// that climb nothing low kerbs, too. Whoever walks there finds out.
constexpr double kSweptAbove = 0.15;

/// Points with so much more room than the body takes are preferred, metres: lines between them touch nothing.
constexpr double kRoomAround = 0.07;

/// A walk has a body that stands and one that crouches, and rarely more than one door.
constexpr std::size_t kMostMaps = 8;

}  // namespace

GroundMap::GroundMap(const collision::World& world, const collision::MoverSettings& body,
                     const collision::QueryFilter& filter)
    : world_(world),
      body_(body),
      lift_(std::min(body.step_height, body.height - 2.0 * body.radius)),
      filter_(filter) {
    if (filter.disabled != nullptr) {
        disabled_ = *filter.disabled;
        filter_.disabled = &disabled_;
    }
}

bool GroundMap::is_for(const collision::World& world, const collision::MoverSettings& body,
                       const collision::QueryFilter& filter) const {
    return &world_ == &world && body_ == body && filter_.detection == filter.detection &&
           filter_.ignored_layers == filter.ignored_layers &&
           (filter.disabled == nullptr ? disabled_.empty() : disabled_ == *filter.disabled);
}

GroundMap::Spots GroundMap::spots_in(const GridCell& cell) {
    const auto is_in = [&](const Tile& tile) {
        return cell.x >= tile.first_cell.x && cell.x - tile.first_cell.x < kCells &&
               cell.z >= tile.first_cell.z && cell.z - tile.first_cell.z < kCells;
    };
    if (tiles_.empty() || !is_in(*tiles_[latest_])) {
        latest_ = tile_of(first_of_square(cell, kCells));
    }
    const Tile& tile = *tiles_[latest_];
    const auto at = static_cast<std::size_t>(tile.index_of(cell));
    return {latest_, tile.first[at], tile.first[at + 1]};
}

std::uint32_t GroundMap::tile_of(const GridCell& first_cell) {
    if (const auto known = numbers_.find(first_cell); known != numbers_.end()) {
        return known->second;
    }
    auto tile = std::make_unique<Tile>();
    tile->first_cell = first_cell;
    fill(*tile);
    tiles_.push_back(std::move(tile));
    const auto number = static_cast<std::uint32_t>(tiles_.size() - 1);
    numbers_.emplace(first_cell, number);
    return number;
}

void GroundMap::drop_covered(std::vector<Level>& levels) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const bool covered = i + 1 < levels.size() && levels[i + 1].cell == levels[i].cell &&
                             levels[i + 1].y - levels[i].y < kCovered;
        if (!covered) {
            levels[count++] = levels[i];
        }
    }
    levels.resize(count);
}

void GroundMap::fill(Tile& tile) const {
    ExploreSettings settings;
    settings.strides.body = body_;
    settings.solids = filter_;
    const collision::Aabb all = world_.bounds();
    const double size = kCells * grid_.cell;
    const Vec3 low(tile.first_cell.x * grid_.cell, all.min.y(), tile.first_cell.z * grid_.cell);
    for (const Surface& surface :
         walkable_surfaces(world_, settings, grid_, {low, {low.x() + size, all.max.y(), low.z() + size}})) {
        if (first_of_square(surface.cell, kCells) == tile.first_cell) {
            const auto cell = static_cast<std::uint16_t>(tile.index_of(surface.cell));
            tile.levels.push_back({static_cast<float>(surface.y), Room::unknown, 0, cell});
        }
    }
    std::ranges::stable_sort(tile.levels, {}, &Level::cell);
    drop_covered(tile.levels);
    for (const Level& level : tile.levels) {
        ++tile.first[level.cell + 1U];
    }
    for (std::size_t i = 1; i < tile.first.size(); ++i) {
        tile.first[i] += tile.first[i - 1];
    }
}

Vec3 GroundMap::point_at(const Tile& tile, const Level& level, std::uint8_t offset) const {
    Vec3 point =
        grid_.center({tile.first_cell.x + level.cell % kCells, tile.first_cell.z + level.cell / kCells});
    point += Vec3(kPoints[offset][0], 0.0, kPoints[offset][1]) * (grid_.cell / 3.0);
    point.y() = level.y;
    return point;
}

Vec3 GroundMap::foot(const Spot& spot) const {
    return point_at(*tiles_[spot.tile], level(spot), level(spot).offset);
}

bool GroundMap::has_room(const Spot& spot) {
    const Tile& tile = *tiles_[spot.tile];
    Level& level = tiles_[spot.tile]->levels[spot.number];
    if (level.room == Room::unknown) {
        const auto offset = free_point(tile, level);
        level.room = offset ? Room::here : Room::none;
        level.offset = offset.value_or(0);
    }
    return level.room == Room::here;
}

std::optional<std::uint8_t> GroundMap::free_point(const Tile& tile, const Level& level) const {
    const auto is_free = [&](std::uint8_t offset, double slimmer) {
        const Vec3 foot = point_at(tile, level, offset) + Vec3(0.0, lift_ + slimmer, 0.0);
        return !collision::obstruction(world_, filter_, foot, body_.radius - slimmer,
                                       body_.height - lift_ - 2.0 * slimmer);
    };
    if (is_free(0, -kRoomAround)) {
        return 0;
    }
    // What a body slimmer by the way to the farthest point touches in the middle, the body touches at each.
    const double farthest = grid_.cell / 3.0 / kDiagonal;
    if (farthest < body_.radius && !is_free(0, farthest)) {
        return std::nullopt;
    }
    for (const double slimmer : {-kRoomAround, 0.0}) {
        for (std::uint8_t i = 0; i < kPointCount; ++i) {
            if (is_free(i, slimmer)) {
                return i;
            }
        }
    }
    return std::nullopt;
}

bool GroundMap::has_room_beside(const Vec3& foot, double beside) const {
    const double lift = std::max(lift_, kSweptAbove);
    const double height = std::max(body_.height - lift, 2.0 * (body_.radius + beside));
    return !collision::obstruction(world_, filter_, foot + Vec3(0.0, lift, 0.0), body_.radius + beside,
                                   height);
}

bool GroundMap::is_path_free(const Vec3& from, const Vec3& to, double beside) const {
    const double lift = std::max(lift_, kSweptAbove);
    const Vec3 foot = from + Vec3(0.0, lift, 0.0);
    const double height = std::max(body_.height - lift, 2.0 * (body_.radius + beside));
    return collision::is_path_free(world_, filter_, foot, body_.radius + beside, height, to - from);
}

GroundMap& GroundMaps::of(const collision::World& world, const collision::MoverSettings& body,
                          const collision::QueryFilter& filter) {
    const auto known = std::ranges::find_if(
        maps_, [&](const std::unique_ptr<GroundMap>& map) { return map->is_for(world, body, filter); });
    if (known != maps_.end()) {
        std::rotate(known, known + 1, maps_.end());
        return *maps_.back();
    }
    if (maps_.size() == kMostMaps) {
        maps_.erase(maps_.begin());
    }
    maps_.push_back(std::make_unique<GroundMap>(world, body, filter));
    return *maps_.back();
}

}  // namespace campuswalk::engine
