#include "scene/osm/meaning/spawns.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/scene/osm/imported_map.h"

namespace campuswalk::scene::osm {
namespace {

using test::MapText;

class Stops : public ImportMap {
protected:
    static MapText::Tags stop() { return {{"highway", "bus_stop"}, {"name", "Campus"}}; }
    /// Where one looks from the stop: east and north.
    Eigen::Vector2d view(const MapText& map, std::int64_t id) {
        const ImportedMap imported = import(map.xml());
        const auto spawn =
            std::ranges::find(imported.draft.spawns, "stop-n" + std::to_string(id), &DraftSpawn::name);
        if (spawn == imported.draft.spawns.end()) {
            ADD_FAILURE() << "no spawn";
            return Eigen::Vector2d::Zero();
        }
        at_ = {spawn->at.x(), -spawn->at.z()};
        const double yaw = spawn->yaw_deg * std::numbers::pi / 180.0;
        return {-std::sin(yaw), std::cos(yaw)};
    }

    Eigen::Vector2d at_ = Eigen::Vector2d::Zero();
};

TEST_F(Stops, LookAtTheNearestDoorOfABuildingWithAName) {
    for (const double east : {-30.0, 20.0}) {
        MapText map;
        const auto id = map.node(0, 0, stop());
        map.rectangle(east, 20, east + 15, 30, {{"building", "yes"}, {"name", "Hall"}});
        map.way({{-60, 10}, {60, 10}}, {{"highway", "footway"}});
        const Eigen::Vector2d seen = view(map, id);
        const Eigen::Vector2d door = Eigen::Vector2d(east + 7.5, 19.0) - at_;
        EXPECT_GT(seen.dot(door.normalized()), 0.99) << east;
    }
}

TEST_F(Stops, DontLookAtTheirPoleNorAtAWall) {
    MapText map;
    const auto id = map.node(0, 0, stop());
    map.rectangle(-40, 1, 40, 20, {{"building", "yes"}});
    map.way({{-60, -60}, {60, -60}}, {{"highway", "footway"}});
    const Eigen::Vector2d seen = view(map, id);
    EXPECT_LT(seen.y(), 0.3) << "a wall is 3 m to the north, the pole 2 m";
}

TEST_F(Stops, OnARoadLookAwayFromTheNextPole) {
    MapText map;
    const auto id = map.node(0, 0, stop());
    map.way_of({map.node(-60, 0), id, map.node(60, 0)}, {{"highway", "residential"}});
    map.rectangle(1, -40, 30, -6, {{"building", "yes"}});
    map.rectangle(-30, 6, 30, 40, {{"building", "yes"}});
    const Eigen::Vector2d seen = view(map, id);
    EXPECT_GT(std::abs(seen.x()), 0.9) << "along the road";
}

TEST_F(Stops, DontLookThroughBuildingsAtDoors) {
    MapText map;
    const auto id = map.node(0, 0, stop());
    map.rectangle(-20, 10, 20, 15, {{"building", "yes"}});
    map.rectangle(-5, 40, 5, 50, {{"building", "yes"}, {"name", "Hidden"}});
    map.way({{-60, 35}, {60, 35}}, {{"highway", "footway"}});
    EXPECT_LT(view(map, id).y(), 0.8);
}

}  // namespace
}  // namespace campuswalk::scene::osm
