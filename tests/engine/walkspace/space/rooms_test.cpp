// A house of 12 m x 8 m about the origin, roofed at 3 m. A wall at x = 0 parts it; doorways of 1 m lead from
// the yard into the east room and from there into the west room.

#include "engine/walkspace/space/rooms.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/engine/small_campus.h"
#include "tests/engine/walkspace/explore/explored_ground.h"

namespace campuswalk::engine {
namespace {

using collision::Vec3;

struct House {
    double wall = 0.2;  ///< thickness, metres
    bool has_lintel = true;
    bool is_furnished = false;
    double doorway = 1.0;  ///< width of the inner one, about z = 1.5
};

scene::Campus campus_with(const House& house) {
    constexpr double kRoof = 3.0;
    constexpr double kDoor = 2.1;
    const double half = 0.5 * house.wall;
    scene::Campus campus = level_campus(9.0);
    add_box(campus, "north", {-6, 0, -4 - half}, {6, kRoof, -4 + half});
    add_box(campus, "west", {-6 - half, 0, -4}, {-6 + half, kRoof, 4});
    add_box(campus, "east", {6 - half, 0, -4}, {6 + half, kRoof, 4});
    add_box(campus, "south-west", {-6, 0, 4 - half}, {3, kRoof, 4 + half});
    add_box(campus, "south-east", {4, 0, 4 - half}, {6, kRoof, 4 + half});
    add_box(campus, "entrance", {3, kDoor, 4 - half}, {4, kRoof, 4 + half});
    add_box(campus, "partition-north", {-half, 0, -4}, {half, kRoof, 1.5 - 0.5 * house.doorway});
    add_box(campus, "partition-south", {-half, 0, 1.5 + 0.5 * house.doorway}, {half, kRoof, 4});
    if (house.has_lintel) {
        add_box(campus, "lintel", {-half, kDoor, 1}, {half, kRoof, 2});
    }
    add_box(campus, "roof", {-6, kRoof, -4}, {6, kRoof + 0.2, 4});
    if (house.is_furnished) {  // with aisles of 0.9 m
        add_box(campus, "table-1", {-5, 0, -3}, {-2, 0.75, -1.5});
        add_box(campus, "table-2", {-5, 0, -0.6}, {-2, 0.75, 0.6});
        add_box(campus, "shelf", {-5, 0, 1.5}, {-2, 1.7, 3});
    }
    return campus;
}

enum Place : std::uint8_t { west, east, yard, doorway };

/// Of a foot point that a body of radius 0.3 m gets to.
Place place_of(const Vec3& foot) {
    const bool is_in_house = std::abs(foot.x()) < 5.8 && std::abs(foot.z()) < 3.8;
    if (std::abs(foot.x()) < 0.4 && foot.z() > 1.0 && foot.z() < 2.0) {
        return doorway;
    }
    if (std::abs(foot.z() - 4.0) < 0.4 && foot.x() > 3.0 && foot.x() < 4.0) {
        return doorway;
    }
    return !is_in_house ? yard : foot.x() < 0.0 ? west : east;
}

struct Found {
    WalkSpace reached;
    std::vector<Room> rooms;  ///< of a square metre or more
};

Found rooms_of(const House& house, const std::vector<KnownDoor>& doors = {}) {
    const scene::Campus campus = campus_with(house);
    Found found{explored(campus, {0, 0, 7}), {}};
    const collision::Aabb house_and_yard{{-8, -1, -6}, {8, 2.5, 8}};
    found.rooms = find_rooms(campus.world, found.reached, house_and_yard, doors);
    std::erase_if(found.rooms, [](const Room& room) { return room.nodes.size() < 16; });
    return found;
}

/// By place, the nodes of the rooms that have any there. Each room must be in one place.
std::vector<std::size_t> nodes_by_place(const Found& found) {
    std::vector<std::size_t> counts(4, 0);
    for (const Room& room : found.rooms) {
        std::vector<std::size_t> own(4, 0);
        for (const WalkNodeId& node : room.nodes) {
            ++own[place_of(found.reached.position(node))];
        }
        own[doorway] = 0;  // which side of it counts to which room is open
        EXPECT_EQ(std::ranges::count(own, 0U), 3) << own[west] << " " << own[east] << " " << own[yard];
        for (std::size_t place = 0; place < own.size(); ++place) {
            counts[place] += own[place];
        }
    }
    return counts;
}

/// The body's middle gets to a floor of this size, metres: all cells that this overlaps may have a node, and
/// all within it but the last row must.
void expect_floor(std::size_t nodes, double width, double depth) {
    const double area = static_cast<double>(nodes) * 0.25 * 0.25;
    EXPECT_GE(area, (width - 0.5) * (depth - 0.5));
    EXPECT_LE(area, (width + 0.5) * (depth + 0.5));
}

TEST(Rooms, DoorwaysPartAHouse) {
    const Found found = rooms_of({});
    ASSERT_EQ(found.rooms.size(), 3U);
    const std::vector<std::size_t> nodes = nodes_by_place(found);
    expect_floor(nodes[west], 6.0 - 0.2 - 0.6, 8.0 - 0.2 - 0.6);
    expect_floor(nodes[east], 6.0 - 0.2 - 0.6, 8.0 - 0.2 - 0.6);
    EXPECT_EQ(place_of(found.reached.position(found.rooms[0].nodes[0])), yard) << "it was reached first";
}

TEST(Rooms, WallsMayBeAsThinAsPaper) {
    EXPECT_EQ(rooms_of({.wall = 0.001}).rooms.size(), 3U);
    nodes_by_place(rooms_of({.wall = 0.001}));
}

TEST(Rooms, AislesBetweenFurnitureAreNoDoorways) {
    const Found found = rooms_of({.is_furnished = true});
    EXPECT_EQ(found.rooms.size(), 3U);
    nodes_by_place(found);
}

TEST(Rooms, ADoorwayMayReachUpToTheCeiling) {
    const Found found = rooms_of({.has_lintel = false});
    EXPECT_EQ(found.rooms.size(), 3U);
    nodes_by_place(found);
}

TEST(Rooms, AWidePassageIsADoorwayIfADoorHangsThere) {
    const House wide{.has_lintel = false, .doorway = 2.2};
    EXPECT_EQ(rooms_of(wide).rooms.size(), 2U) << "both rooms are one";
    EXPECT_EQ(rooms_of(wide, {{{0.0, 0.0, 1.5}, 2.2}}).rooms.size(), 3U);
}

TEST(Rooms, AGateDoesNotPartAYard) {
    EXPECT_EQ(rooms_of({}, {{{0.0, 0.0, 7.0}, 6.0}}).rooms.size(), 3U);
}

}  // namespace
}  // namespace campuswalk::engine
