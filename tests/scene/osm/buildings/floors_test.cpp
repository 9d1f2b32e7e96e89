#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/scene/osm/imported_map.h"

namespace campuswalk::scene::osm {
namespace {

using test::MapText;

/// What is above, below and inside of buildings.
class Floors : public ImportMap {
protected:
    static std::string message_of(const ImportedMap& imported, const std::string& code) {
        for (const Diagnostic& warning : imported.warnings) {
            if (warning.code.text() == code) {
                return warning.message;
            }
        }
        return "";
    }
    /// A building of 9 m over 40 m by 40 m.
    ImportedMap with_way(const MapText::Points& line, const MapText::Tags& tags,
                         const MapText::Tags& building = {{"building", "yes"}}) {
        MapText map;
        MapText::Tags all = building;
        all.emplace_back("height", "9");
        hall_ = "building/way-" + std::to_string(map.rectangle(-20, -20, 20, 20, all));
        way_ = map.way(line, tags);
        map.way({{-60, -40}, {60, -40}}, {{"highway", "footway"}});
        return import(map.xml());
    }

    std::string hall_;
    std::int64_t way_ = 0;
};

constexpr double kWhole = 1600.0 * 9.0;

TEST_F(Floors, AreLeftOutWithACount) {
    const MapText::Points inside = {{-15, -5}, {15, -5}};
    const std::vector<MapText::Tags> floors = {{{"highway", "footway"}, {"layer", "3"}},
                                               {{"highway", "footway"}, {"level", "2"}},
                                               {{"highway", "footway"}, {"indoor", "yes"}},
                                               {{"highway", "footway"}, {"indoor", "yes"}, {"level", "0"}},
                                               {{"highway", "footway"}, {"layer", "-1"}},
                                               {{"highway", "corridor"}},
                                               {{"highway", "corridor"}, {"level", "1;2"}},
                                               {{"highway", "steps"}, {"level", "0;1"}},
                                               {{"highway", "steps"}, {"indoor", "yes"}, {"level", "0;1"}}};
    for (const MapText::Tags& tags : floors) {
        const ImportedMap imported = with_way(inside, tags);
        const std::string tag = tags.back().first + "=" + tags.back().second;
        EXPECT_NEAR(volume_of(imported.model, hall_), kWhole, 5.0) << tag;
        EXPECT_TRUE(
            message_of(imported, "indoor-ways").starts_with("1 way (way " + std::to_string(way_) + ") "))
            << tag;
        for (const Node& node : imported.model.nodes) {
            EXPECT_FALSE(node.name.ends_with("/way-" + std::to_string(way_))) << node.name;
        }
    }
}

TEST_F(Floors, FromWallToWallAreLeftOutAboveTheGroundOnly) {
    const MapText::Points through = {{0, -20}, {0, 20}};
    EXPECT_NEAR(volume_of(with_way(through, {{"highway", "footway"}, {"layer", "1"}}).model, hall_), kWhole,
                5.0);
    const ImportedMap passage = with_way(through, {{"highway", "footway"}, {"indoor", "yes"}});
    EXPECT_LT(volume_of(passage.model, hall_), kWhole - 200.0) << "one walks through";
    EXPECT_EQ(message_of(passage, "indoor-ways"), "");
}

TEST_F(Floors, AreNotWhatLiesOutside) {
    for (const MapText::Points& line : {MapText::Points{{15, 0}, {60, 0}}, {{30, -5}, {30, 5}}}) {
        for (const MapText::Tags& tags : {MapText::Tags{{"highway", "footway"}, {"layer", "1"}},
                                          {{"highway", "footway"}, {"level", "1"}}}) {
            EXPECT_EQ(message_of(with_way(line, tags), "indoor-ways"), "");
        }
    }
    const MapText::Tags tagged = {{"highway", "footway"}, {"layer", "1"}, {"tunnel", "building_passage"}};
    EXPECT_EQ(message_of(with_way({{0, -15}, {0, 30}}, tagged), "indoor-ways"), "");
    EXPECT_EQ(message_of(with_way({{-15, 0}, {15, 0}}, {{"highway", "footway"}, {"level", "1"}},
                                  {{"building", "roof"}}),
                         "indoor-ways"),
              "")
        << "below a roof on posts one is outside";
}

TEST_F(Floors, OfManyLayersLeaveTheBuildingWhole) {
    MapText map;
    const auto hall = map.rectangle(-40, -40, 40, 40, {{"building", "yes"}, {"height", "36"}});
    std::int64_t first = 0;
    for (int i = 0; i < 288; ++i) {
        const double at = -36.0 + 6.0 * (i % 12);
        const bool east = i % 24 < 12;
        const auto id =
            map.way({{east ? -36.0 : at, east ? at : -36.0}, {east ? 36.0 : at, east ? at : 36.0}},
                    {{"highway", "footway"}, {"layer", std::to_string(1 + i / 24)}});
        first = first == 0 ? id : first;
    }
    const ImportedMap imported = import(map.xml());
    EXPECT_TRUE(message_of(imported, "indoor-ways")
                    .starts_with("288 ways (the first: way " + std::to_string(first) + ") are"));
    EXPECT_NEAR(volume_of(imported.model, "building/way-" + std::to_string(hall)), 6400.0 * 36.0, 50.0);
    std::size_t triangles = 0;
    for (const Mesh& mesh : imported.model.meshes) {
        triangles += mesh.triangles.size();
    }
    EXPECT_LT(triangles, 20'000U);
}

TEST_F(ImportMap, BuildsBuildingsOnNegativeLayersThatStandAboveTheGround) {
    for (const char* key : {"height", "building:levels", "building"}) {
        MapText map;
        MapText::Tags tags = {{"building", "college"}, {"layer", "-1"}, {"name", "Elm Hall"}};
        tags.emplace_back(key, "5");
        const auto id = map.rectangle(-10, -10, 10, 10, tags);
        map.way({{-60, -40}, {60, -40}}, {{"highway", "footway"}});
        const ImportedMap imported = import(map.xml());
        const bool high = std::string(key) != "building";
        EXPECT_EQ(find(imported.model, "building/way-" + std::to_string(id)) != nullptr, high) << key;
        const auto warning =
            std::ranges::find(imported.warnings, DiagnosticCode("underground-building"), &Diagnostic::code);
        ASSERT_EQ(warning == imported.warnings.end(), high) << key;
        if (!high) {
            EXPECT_TRUE(warning->message.starts_with("way-" + std::to_string(id) + " (Elm Hall) "));
        }
    }
}

TEST_F(ImportMap, NamesBuildingsOfManyKilometres) {
    for (const double length : {4'000.0, 6'000.0}) {
        MapText map;
        const auto id = map.rectangle(-10, -10, length, 10, {{"building", "yes"}, {"height", "5"}});
        const ImportedMap imported = import(map.xml());
        const bool built = length < 5'000.0;
        EXPECT_EQ(find(imported.model, "building/way-" + std::to_string(id)) != nullptr, built);
        EXPECT_EQ(std::ranges::count(imported.warnings, DiagnosticCode("huge-building"), &Diagnostic::code),
                  built ? 0 : 1);
    }
}

TEST_F(ImportMap, NamesBuildingsAndPartsBelowTheGround) {
    const std::vector<MapText::Tags> below = {
        {{"building", "yes"}, {"location", "underground"}, {"height", "5"}},
        {{"building", "parking"}, {"parking", "underground"}},
        {{"building", "yes"}, {"level", "-1"}},
        {{"building", "yes"}, {"building:levels", "0"}, {"building:levels:underground", "2"}},
        {{"building:part", "yes"}, {"location", "underground"}},
        {{"building:part", "yes"}, {"layer", "-2"}}};
    for (const MapText::Tags& tags : below) {
        MapText map;
        const auto id = map.rectangle(-10, -10, 10, 10, tags);
        map.way({{-60, -40}, {60, -40}}, {{"highway", "footway"}});
        const ImportedMap imported = import(map.xml());
        EXPECT_EQ(find(imported.model, "building/way-" + std::to_string(id)), nullptr);
        EXPECT_EQ(
            std::ranges::count(imported.warnings, DiagnosticCode("underground-building"), &Diagnostic::code),
            1)
            << tags.back().first;
    }
}

TEST_F(ImportMap, PutsEntrancesOfFloorsWhereAWayLeadsToThem) {
    MapText map;
    const auto led_to = map.node(5, 0, {{"entrance", "main"}, {"level", "1"}});
    const auto bridged = map.node(20, 5, {{"entrance", "yes"}, {"level", "2"}});
    const auto lost = map.node(12, 0, {{"entrance", "yes"}, {"level", "3"}});
    map.way_of({map.node(0, 0), led_to, lost, map.node(20, 0), bridged, map.node(20, 10), map.node(0, 10), 4},
               {{"building", "yes"}, {"name", "Hall"}, {"height", "15"}});
    map.way_of({led_to, map.node(5, -30)}, {{"highway", "footway"}});
    map.way_of({bridged, map.node(60, 5)}, {{"highway", "footway"}, {"bridge", "yes"}, {"layer", "1"}});
    map.way({{40, -50}, {40, 50}}, {{"highway", "residential"}});
    const ImportedMap imported = import(map.xml());
    const auto door = [&](std::int64_t node) { return "door/node-" + std::to_string(node); };
    ASSERT_NE(find(imported.model, door(led_to)), nullptr);
    EXPECT_NEAR(bounds_of(imported.model, door(led_to)).min.y(), -0.05, 0.01);
    EXPECT_NEAR(
        bounds_of(imported.model, door(led_to)).max.x() - bounds_of(imported.model, door(led_to)).min.x(),
        1.8, 0.01)
        << "it is the main one";
    ASSERT_NE(find(imported.model, door(bridged)), nullptr);
    EXPECT_GT(bounds_of(imported.model, door(bridged)).min.y(), 4.0) << "on the bridge";
    EXPECT_EQ(find(imported.model, door(lost)), nullptr);
    const auto warning =
        std::ranges::find(imported.warnings, DiagnosticCode("entrance-on-floor"), &Diagnostic::code);
    ASSERT_NE(warning, imported.warnings.end());
    EXPECT_TRUE(warning->message.starts_with("1 entrance (node " + std::to_string(lost) + ", level=3) is"));
}

TEST_F(ImportMap, PutsAnEntranceToWhichOnlyABridgeLeadsOnTheBridge) {
    MapText map;
    const auto bridged = map.node(20, 5, {{"entrance", "main"}});
    map.way_of({map.node(0, 0), map.node(20, 0), bridged, map.node(20, 10), map.node(0, 10), 2},
               {{"building", "yes"}, {"name", "Hall"}, {"height", "15"}});
    map.way_of({bridged, map.node(60, 5)}, {{"highway", "footway"}, {"bridge", "yes"}, {"layer", "1"}});
    map.way({{40, -50}, {40, 50}}, {{"highway", "residential"}});
    const ImportedMap imported = import(map.xml());
    EXPECT_GT(bounds_of(imported.model, "door/node-" + std::to_string(bridged)).min.y(), 4.0);
}

}  // namespace
}  // namespace campuswalk::scene::osm
