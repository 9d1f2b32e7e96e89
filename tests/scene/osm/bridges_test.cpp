#include "scene/osm/bridges.h"

#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/scene/osm/imported_map.h"

namespace campuswalk::scene::osm {
namespace {

using test::MapText;

constexpr double kRoadClearance = 4.5;
constexpr double kDeck = 0.4;
constexpr double kAbove = 0.02;  // of a deck beside the ground

class Bridges : public ImportMap {
protected:
    /// A road that runs east, and a bridge over it that runs north, with footways at its ends.
    MapText footbridge(const MapText::Tags& road = {}) {
        MapText map;
        MapText::Tags tags = {{"highway", "residential"}, {"width", "6"}};
        tags.insert(tags.end(), road.begin(), road.end());
        map.way({{-90, 0}, {90, 0}}, tags);
        const auto south = map.node(0, -25);
        const auto north = map.node(0, 25);
        bridge_ = map.way_of({south, north},
                             {{"highway", "footway"}, {"bridge", "yes"}, {"layer", "1"}, {"width", "3"}});
        map.way_of({map.node(0, -80), south}, {{"highway", "footway"}});
        map.way_of({north, map.node(0, 80)}, {{"highway", "footway"}});
        return map;
    }
    std::string name() const { return "bridge/way-" + std::to_string(bridge_); }

    std::int64_t bridge_ = 0;
};

TEST_F(Bridges, HaveTheClearanceOfWhatPassesBelow) {
    for (const auto& [tagged, clearance] : {std::pair{"", kRoadClearance}, {"3.2", 3.2}, {"5", 5.0}}) {
        MapText map = footbridge(*tagged == '\0' ? MapText::Tags() : MapText::Tags{{"maxheight", tagged}});
        const Model model = import(map.xml()).model;
        ASSERT_NE(find(model, name()), nullptr);
        for (const double north : {-20.0, 0.0, 20.0}) {
            EXPECT_NEAR(top_at(model, 0, north, name()), clearance + kDeck + kAbove, 0.005) << north;
        }
        EXPECT_NEAR(bounds_of(model, name()).min.y(), clearance, 0.005) << "its underside";
        // Posts and handrails stand on it.
        EXPECT_NEAR(bounds_of(model, name()).max.y(), clearance + kDeck + kAbove + 1.1, 0.005);
    }
}

TEST_F(Bridges, CoverTheirWidth) {
    MapText map = footbridge();
    const Model model = import(map.xml()).model;
    // A ribbon of 50 m by 3 m with round ends, as polygons of 16 sides have them; its underside is as large.
    const double side = std::numbers::pi / 16.0;
    const double area = 50.0 * 3.0 + 16.0 * 1.5 * 1.5 * std::sin(side) * std::cos(side);
    EXPECT_NEAR(plan_area(model, *find(model, name()), -1.0), area, 0.01 * area);
}

TEST_F(Bridges, AreReachedOverGroundThatRisesGently) {
    MapText map = footbridge();
    const Model model = import(map.xml()).model;
    EXPECT_NEAR(top_at(model, 0.3, 0.2, "residential/"), -0.12, 1e-3) << "the road stays where it is";
    EXPECT_NEAR(top_at(model, 0.3, 26.5, "footway/"), kRoadClearance + kDeck, 0.02) << "behind the end";
    double before = top_at(model, 0.3, 26.5, "footway/");
    for (double north = 27.5; north < 79.0; north += 1.0) {
        const double height = top_at(model, 0.3, north, "footway/");
        EXPECT_LE(std::abs(height - before), 0.17) << "one in six, at " << north;
        before = height;
    }
    EXPECT_NEAR(before, 0.0, 1e-3);
}

TEST_F(Bridges, LeadDownByStairs) {
    MapText map;
    map.way({{-90, 0}, {90, 0}}, {{"highway", "residential"}, {"width", "6"}});
    const auto south = map.node(0, -12);
    const auto north = map.node(0, 12);
    map.way_of({south, north}, {{"highway", "footway"}, {"bridge", "yes"}});
    const auto foot = map.node(-10, -12);
    const auto flight =
        map.way_of({foot, south}, {{"highway", "steps"}, {"step_count", "30"}, {"handrail", "yes"}});
    map.way_of({north, map.node(10, 12)}, {{"highway", "steps"}});
    map.way_of({foot, map.node(-50, -12)}, {{"highway", "footway"}});
    const Model model = import(map.xml()).model;
    std::set<int> treads;
    for_triangles(model, *find(model, "steps/way-" + std::to_string(flight)),
                  [&](const auto& a, const auto& b, const auto& c) {
                      if (a.y() == b.y() && b.y() == c.y() && (b - a).cross(c - a).y() > 0.2) {
                          treads.insert(static_cast<int>(std::lround(1000.0 * a.y())));
                      }
                  });
    const int top = static_cast<int>(std::lround(1000.0 * (kRoadClearance + kDeck)));
    EXPECT_TRUE(treads.contains(top)) << "the last tread is level with the deck";
    EXPECT_TRUE(treads.contains(static_cast<int>(std::lround(top / 30.0)))) << "30 equal risers";
    EXPECT_NEAR(top_at(model, 0, -30, "ground"), 0.0, 1e-3) << "the ground needs no hill";
}

TEST_F(Bridges, SpanWater) {
    MapText map;
    map.rectangle(-40, -8, 40, 8, {{"natural", "water"}});
    const auto id = map.way({{0, -15}, {0, 15}}, {{"highway", "footway"}, {"bridge", "yes"}});
    map.way({{0, -40}, {0, -15}}, {{"highway", "footway"}});
    const Model model = import(map.xml()).model;
    EXPECT_NEAR(top_at(model, 0.1, 0.1, "bridge/way-" + std::to_string(id)), 0.6 + kDeck + kAbove, 0.005);
    EXPECT_NEAR(top_at(model, 0.1, 0.1, "water/"), -1.2, 1e-3) << "the water goes on below";
}

TEST_F(Bridges, CrossEachOther) {
    MapText map;
    map.way({{-90, 0}, {90, 0}}, {{"highway", "residential"}});
    map.way({{0, -30}, {0, 30}}, {{"highway", "footway"}, {"bridge", "yes"}, {"layer", "1"}});
    const auto high =
        map.way({{-40, -12}, {40, 12}}, {{"highway", "footway"}, {"bridge", "yes"}, {"layer", "2"}});
    const Model model = import(map.xml()).model;
    const double lower = kRoadClearance + kDeck;
    EXPECT_NEAR(top_at(model, 0.0, 0.1, "bridge/way-" + std::to_string(high)), lower + 2.5 + kDeck + kAbove,
                0.01)
        << "2.5 m for walkers";
}

TEST_F(Bridges, LeadThroughBuildings) {
    MapText map;
    map.way({{-90, 0}, {90, 0}}, {{"highway", "service"}});
    const auto house = map.rectangle(-10, 10, 10, 30, {{"building", "yes"}, {"height", "12"}});
    map.way({{0, -20}, {0, 50}}, {{"highway", "footway"}, {"bridge", "yes"}, {"layer", "1"}, {"width", "2"}});
    const Model model = import(map.xml()).model;
    // 3 m wide, 20 m long and 2.7 m high.
    const std::string name = "building/way-" + std::to_string(house);
    EXPECT_NEAR(volume_of(model, name), 400.0 * 12.0 - 3.0 * 20.0 * 2.7, 4.0);
}

TEST_F(Bridges, AreReportedWhereNothingPassesBelow) {
    MapText map;
    const auto bridge = map.way({{0, -25}, {0, 25}}, {{"highway", "footway"}, {"bridge", "yes"}});
    map.way({{-50, 40}, {50, 40}}, {{"highway", "service"}, {"tunnel", "yes"}, {"layer", "-1"}});
    map.way({{-50, 60}, {50, 60}}, {{"highway", "footway"}, {"layer", "-1"}});
    const ImportedMap imported = import(map.xml());
    EXPECT_TRUE(test::has_code(imported.warnings, "bridge-at-ground"));
    EXPECT_EQ(std::ranges::count(imported.warnings, "underground", &Diagnostic::code), 2);
    EXPECT_EQ(find(imported.model, "bridge/way-" + std::to_string(bridge)), nullptr);
    EXPECT_NEAR(top_at(imported.model, 0.1, 0.1, "footway/way-" + std::to_string(bridge)), 0.0, 1e-6);
}

}  // namespace
}  // namespace campuswalk::scene::osm
