#include "scene/osm/bridges/bridges.h"

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
    for (int i = 0; i < 52; ++i) {
        const double north = 27.5 + i;
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
    // 2 m wide, 20 m long and 2.7 m high.
    const std::string name = "building/way-" + std::to_string(house);
    EXPECT_NEAR(volume_of(model, name), 400.0 * 12.0 - 2.0 * 20.0 * 2.7, 4.0);
}

/// Of a deck over the road, in the plan: what faces down at its underside.
double deck_area(const Model& model, const std::string& name) {
    double area = 0.0;
    for_triangles(model, *find(model, name), [&](const auto& a, const auto& b, const auto& c) {
        if (std::max({a.y(), b.y(), c.y()}) < kRoadClearance + 0.01) {
            area += std::max(0.0, -0.5 * (b - a).cross(c - a).y());
        }
    });
    return area;
}

TEST_F(Bridges, ReachAsFarAsTheirOutlines) {
    MapText map = footbridge();
    map.rectangle(-4, -26.5, 3, 26.5, {{"man_made", "bridge"}, {"layer", "1"}});
    const Model model = import(map.xml()).model;
    EXPECT_NEAR(deck_area(model, name()), 7.0 * 53.0, 0.05);
    const double deck = kRoadClearance + kDeck + kAbove;
    for (const double east : {-3.7, -1.0, 0.0, 2.7}) {
        EXPECT_NEAR(top_at(model, east, 0.3, name()), deck, 0.005) << east;
    }
    const Bounds bounds = bounds_of(model, name());
    EXPECT_NEAR(bounds.min.x(), -4.0, 0.01);
    EXPECT_NEAR(bounds.max.x(), 3.0, 0.01);
    EXPECT_NEAR(bounds.max.y(), deck + 1.1, 0.005) << "parapets stand at the outline";
}

TEST_F(Bridges, OfTwoRoadsInOneOutlineHaveNoParapetBetween) {
    MapText map;
    map.way({{-90, 0}, {90, 0}}, {{"highway", "residential"}, {"width", "6"}});
    std::string nodes[2];
    for (int i = 0; i < 2; ++i) {
        const double east = i == 0 ? -2.0 : 2.5;
        const auto south = map.node(east, -25);
        const auto north = map.node(east, 25);
        nodes[i] =
            "bridge/way-" + std::to_string(map.way_of(
                                {south, north}, {{"highway", "footway"}, {"bridge", "yes"}, {"width", "2"}}));
        map.way_of({map.node(east, -80), south}, {{"highway", "footway"}});
        map.way_of({north, map.node(east, 80)}, {{"highway", "footway"}});
    }
    const auto is_free_between = [&](const Model& model) {
        const double deck = kRoadClearance + kDeck + kAbove;
        for (const std::string& node : nodes) {
            bool free = true;
            for_triangles(model, *find(model, node), [&](const auto& a, const auto& b, const auto& c) {
                for (const Eigen::Vector3d& p : {a, b, c}) {
                    free = free &&
                           !(p.x() > -1.5 && p.x() < 2.0 && std::abs(p.z()) < 20.0 && p.y() > deck + 0.1);
                }
            });
            if (!free) {
                return false;
            }
        }
        return true;
    };
    EXPECT_FALSE(is_free_between(import(map.xml()).model)) << "two bridges";
    map.rectangle(-4, -27, 4, 27, {{"man_made", "bridge"}});
    const Model model = import(map.xml()).model;
    EXPECT_TRUE(is_free_between(model)) << "one";
    EXPECT_NEAR(deck_area(model, nodes[0]) + deck_area(model, nodes[1]), 8.0 * 54.0, 0.05);
}

TEST_F(Bridges, StandOnPiers) {
    MapText map = footbridge();
    const auto round = map.node(0, 10, {{"bridge:support", "pier"}, {"width", "0.8"}});
    const auto square = map.rectangle(-1, -12, 1, -11, {{"bridge:support", "pier"}});
    map.node(30, 10, {{"bridge:support", "pier"}});
    const ImportedMap imported = import(map.xml());
    EXPECT_EQ(std::ranges::count(imported.warnings, DiagnosticCode("pier-without-bridge"), &Diagnostic::code),
              1);
    for (const auto& [name, north] : {std::pair("bridge-pier/node-" + std::to_string(round), 10.0),
                                      std::pair("bridge-pier/way-" + std::to_string(square), -11.5)}) {
        ASSERT_NE(find(imported.model, name), nullptr) << name;
        const Bounds bounds = bounds_of(imported.model, name);
        EXPECT_NEAR(bounds.max.y(), kRoadClearance + 0.1, 0.01) << "into the deck";
        EXPECT_LT(bounds.min.y(), top_at(imported.model, 0.1, north, "ground")) << "into the ground";
    }
    EXPECT_NEAR(bounds_of(imported.model, "bridge-pier/node-" + std::to_string(round)).max.x(), 0.4, 0.01);
    const auto solid = std::ranges::find(imported.draft.solids, "bridge-pier", &DraftSolid::id);
    EXPECT_NE(solid, imported.draft.solids.end()) << "visitors bump into them";
}

TEST_F(Bridges, AreReportedWhereNothingPassesBelow) {
    MapText map;
    const auto bridge = map.way({{0, -25}, {0, 25}}, {{"highway", "footway"}, {"bridge", "yes"}});
    map.way({{-50, 40}, {50, 40}}, {{"highway", "service"}, {"tunnel", "yes"}, {"layer", "-1"}});
    map.way({{-50, 60}, {50, 60}}, {{"highway", "footway"}, {"layer", "-1"}});
    const ImportedMap imported = import(map.xml());
    EXPECT_TRUE(test::has_code(imported.warnings, "bridge-at-ground"));
    EXPECT_EQ(std::ranges::count(imported.warnings, DiagnosticCode("underground"), &Diagnostic::code), 2);
    EXPECT_EQ(find(imported.model, "bridge/way-" + std::to_string(bridge)), nullptr);
    EXPECT_NEAR(top_at(imported.model, 0.1, 0.1, "footway/way-" + std::to_string(bridge)), 0.0, 1e-6);
}

TEST_F(Bridges, EndWhereTheGroundEnds) {
    MapText map;
    const auto bridge = map.way({{50, 30}, {450, 30}},
                                {{"highway", "primary"}, {"bridge", "yes"}, {"layer", "1"}, {"width", "8"}});
    map.way({{60, -50}, {60, 90}}, {{"highway", "residential"}});
    map.rectangle(90, -10, 130, 10, {{"building", "yes"}, {"height", "6"}});
    const auto steps = map.way({{0, 90}, {0, 130}}, {{"highway", "steps"}, {"step_count", "50"}});
    const Model model = import(map.xml()).model;
    const Bounds ground = bounds_of(model, "ground");
    EXPECT_NEAR(ground.max.x(), 135.0, 1.01) << "5 m beyond the building that begins in the map";
    const Bounds deck = bounds_of(model, "bridge/way-" + std::to_string(bridge));
    EXPECT_NEAR(deck.max.x(), ground.max.x(), 0.1) << "parapets have a breadth";
    EXPECT_GT(top_at(model, ground.max.x() - 0.5, 30, "bridge/"), 4.0);
    EXPECT_EQ(find(model, "steps/way-" + std::to_string(steps) + "/treads"), nullptr);
    for (const Node& node : model.nodes) {
        const Bounds bounds = bounds_of(model, node.name);
        EXPECT_LT(bounds.max.x(), ground.max.x() + 0.1) << node.name;
        EXPECT_GT(bounds.min.z(), ground.min.z() - 0.1) << node.name;
    }
}

}  // namespace
}  // namespace campuswalk::scene::osm
