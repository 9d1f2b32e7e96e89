#include "engine/walkspace/space/rooms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "collision/geometry/disjoint_sets.h"
#include "collision/world/cast.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// Neighbours whose heights differ by more are a step or a ramp, metres.
constexpr double kLevelFloor = 0.03;
constexpr double kThreshold = 0.1;  // of a doorway, metres
/// Where a body's middle gets to in a doorway of 1.6 m, and one cell more, metres.
constexpr double kNarrow = 1.26;
constexpr double kWidestDoor = 2.5;  // metres: what is wider is a gate
constexpr double kBesideDoor = 0.15;

/// From the middle of a row's last cell into the wall beside: more than a body's radius and half a cell.
constexpr double kIntoWall = 0.45;
/// It may be as narrow so far before and behind a doorway's middle, metres.
constexpr double kDoorwayDepth = 0.75;
constexpr double kLowestLintel = 1.85;  // metres above the feet
constexpr double kHighestLintel = 2.8;
constexpr double kRise = 0.1;  // from one height at which it is looked for to the next
/// A lintel is looked for so far before and behind a place: more than a cell's half diagonal, so that those
/// below it bar the passage. Beyond begin the rooms.
constexpr double kLintelReach = 0.25;
constexpr std::array<double, 3> kIntoRoom{0.4, 0.65, 0.9};

bool is_free(const collision::World& world, const Vec3& from, const Vec3& to) {
    return !collision::cast(world, {}, {from, to}, collision::Detection::solid);
}

/// Whether there is air beside a place, from the height of a head to this one.
bool has_room_above(const collision::World& world, const Vec3& foot, const Vec3& aside, double height) {
    return std::ranges::any_of(kIntoRoom, [&](double reach) {
        const Vec3 at = foot + reach * aside;
        return is_free(world, at + kLowestLintel * Vec3::UnitY(), at + height * Vec3::UnitY());
    });
}

/// Whether one who goes ahead from the place, or comes from there, passes below a lintel.
bool is_below_lintel(const collision::World& world, const Vec3& foot, const Vec3& ahead) {
    const Vec3 reach = kLintelReach * ahead;
    for (int i = 0; kLowestLintel + i * kRise <= kHighestLintel; ++i) {
        const double height = kLowestLintel + i * kRise;
        const Vec3 above = foot + height * Vec3::UnitY();
        if (!is_free(world, above - reach, above + reach)) {
            return has_room_above(world, foot, ahead, height + kRise) &&
                   has_room_above(world, foot, -ahead, height + kRise);
        }
    }
    return false;
}

/// Reached cells side by side, through one of them.
struct Row {
    double before = 0.0;  ///< metres from the cell's middle to that of the first
    double behind = 0.0;  ///< to that of the last
    double pitch = 0.0;   ///< from one middle to the next

    bool is_narrow() const { return before + behind + pitch <= kNarrow; }
};

double pitch_along(const WalkSpace& reached, const GridDirection& direction) {
    return reached.grid.cell * (direction.x != 0 && direction.z != 0 ? 1.0 / kDiagonal : 1.0);
}

/// The cell so many cells farther on, if it is reached at about this height.
std::optional<WalkNodeId> node_along(const WalkSpace& reached, const WalkNodeId& from,
                                     const GridDirection& direction, int cells) {
    const GridCell cell = reached.cell_of(from);
    return reached.find({cell.x + cells * direction.x, cell.z + cells * direction.z},
                        static_cast<double>(reached.node(from).y), kThreshold);
}

/// No longer than what isn't narrow.
Row row_through(const WalkSpace& reached, const WalkNodeId& node, const GridDirection& direction) {
    const double pitch = pitch_along(reached, direction);
    const auto most = static_cast<int>(kNarrow / pitch) + 1;
    const auto cells_to = [&](int side) {
        int cells = 0;
        while (cells < most && node_along(reached, node, direction, side * (cells + 1))) {
            ++cells;
        }
        return cells;
    };
    return {cells_to(-1) * pitch, cells_to(1) * pitch, pitch};
}

/// Whether a wall stands at both ends of the row: at the height of a head, over most furniture, one doesn't
/// get ahead there either.
bool is_between_walls(const collision::World& world, const Vec3& foot, const Row& row, const Vec3& across,
                      const Vec3& ahead) {
    const auto has_wall = [&](double aside) {
        const Vec3 at = foot + aside * across + kLowestLintel * Vec3::UnitY();
        return !is_free(world, at - kLintelReach * ahead, at + kLintelReach * ahead);
    };
    return has_wall(-row.before - kIntoWall) && has_wall(row.behind + kIntoWall);
}

/// Whether it is wider than a doorway both in front and behind.
bool is_constriction(const WalkSpace& reached, const WalkNodeId& node, const GridDirection& across,
                     const GridDirection& ahead) {
    const auto cells = static_cast<int>(std::lround(kDoorwayDepth / pitch_along(reached, ahead)));
    return std::ranges::all_of(std::array{-cells, cells}, [&](int away) {
        const auto beyond = node_along(reached, node, ahead, away);
        return beyond && !row_through(reached, *beyond, across).is_narrow();
    });
}

bool is_in_doorway(const collision::World& world, const WalkSpace& reached, const WalkNodeId& node) {
    constexpr std::array<std::pair<std::size_t, std::size_t>, 4> kAcrossAndAhead{
        {{0, 1}, {1, 0}, {4, 5}, {5, 4}}};
    const Vec3 foot = reached.position(node);
    return std::ranges::any_of(kAcrossAndAhead, [&](const auto& pair) {
        const GridDirection& across = grid_directions()[pair.first];
        const GridDirection& ahead = grid_directions()[pair.second];
        const Row row = row_through(reached, node, across);
        return row.is_narrow() && is_between_walls(world, foot, row, across.unit, ahead.unit) &&
               (is_constriction(reached, node, across, ahead) || is_below_lintel(world, foot, ahead.unit));
    });
}

bool is_at(const KnownDoor& door, const Vec3& foot) {
    constexpr double kMostApart = 0.5;  // metres in height
    return door.width <= kWidestDoor && std::abs(door.foot.y() - foot.y()) <= kMostApart &&
           collision::horizontal_norm(door.foot - foot) <= 0.5 * door.width + kBesideDoor;
}

}  // namespace

std::vector<Room> find_rooms(const collision::World& world, const WalkSpace& reached,
                             const collision::Aabb& within, std::span<const KnownDoor> doors) {
    std::vector<WalkNodeId> floor = reached.nodes_in(within);
    std::erase_if(floor, [&](const WalkNodeId& node) {
        const Vec3 foot = reached.position(node);
        return reached.node(node).hangs != 0 ||
               std::ranges::any_of(doors, [&](const KnownDoor& door) { return is_at(door, foot); }) ||
               is_in_doorway(world, reached, node);
    });
    collision::DisjointSets sets(floor.size());
    for (std::size_t i = 0; i < floor.size(); ++i) {
        const GridCell cell = reached.cell_of(floor[i]);
        const auto y = static_cast<double>(reached.node(floor[i]).y);
        for (const GridDirection& to : grid_directions()) {
            const auto beside = reached.find({cell.x + to.x, cell.z + to.z}, y, kLevelFloor);
            const auto found = beside ? std::ranges::lower_bound(floor, *beside) : floor.end();
            if (found != floor.end() && *found == *beside) {
                sets.join(i, static_cast<std::size_t>(found - floor.begin()));
            }
        }
    }
    std::vector<Room> rooms;
    std::vector<std::size_t> room_of(floor.size());
    for (std::size_t i = 0; i < floor.size(); ++i) {
        const std::size_t first = sets.root(i);
        if (first == i) {
            room_of[i] = rooms.size();
            rooms.emplace_back();
        }
        rooms[room_of[first]].nodes.push_back(floor[i]);
    }
    return rooms;
}

}  // namespace campuswalk::engine
