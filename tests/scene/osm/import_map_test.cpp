#include "scene/osm/import_map.h"

#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "scene/osm/geometry/areas.h"
#include "scene/osm/geometry/plan_geometry.h"
#include "scene/osm/read/tag_values.h"
#include "tests/scene/osm/imported_map.h"

namespace campuswalk::scene::osm {
namespace {

using test::MapText;

TEST(TagValues, ReadsLengthsAndColors) {
    EXPECT_DOUBLE_EQ(*length_of("3.5"), 3.5);
    EXPECT_DOUBLE_EQ(*length_of("3,5 m"), 3.5);
    EXPECT_DOUBLE_EQ(*length_of("10 ft"), 3.048);
    EXPECT_NEAR(*length_of("12'6\""), 3.81, 1e-9);
    for (const char* twelve :
         {"12 meter", "12 M", "12 Metres", "~12", "ca. 12", "+12 m", "12 m;14 m", "1200 cm"}) {
        ASSERT_TRUE(length_of(twelve)) << twelve;
        EXPECT_NEAR(*length_of(twelve), 12.0, 1e-9) << twelve;
    }
    for (const char* forty :
         {"40 foot", "40'", "40\u2019", "40\u2032 0\u2033", "480\"", "480 inches", "40 FT"}) {
        ASSERT_TRUE(length_of(forty)) << forty;
        EXPECT_NEAR(*length_of(forty), 12.192, 1e-9) << forty;
    }
    for (const char* bad :
         {"", "high", "1e999", "nan", "inf", "5 parsec", "3 m!", "1e9", "12-14", "~", "12 m 5"}) {
        EXPECT_FALSE(length_of(bad).has_value()) << bad;
    }
    EXPECT_EQ(*color_of("#d0a080"), (Color{0xd0, 0xa0, 0x80}));
    EXPECT_EQ(*color_of("#fff"), (Color{255, 255, 255}));
    EXPECT_FALSE(color_of("#ggg").has_value());
    EXPECT_FALSE(color_of("colourful").has_value());
}

TEST_F(ImportMap, MakesBuildingsOfTheirAreaAndHeight) {
    MapText map;
    const auto outer = map.rectangle(-30, -20, 30, 20);
    const auto inner = map.rectangle(-10, -10, 10, 10);
    const auto id = map.relation({{outer, "outer"}, {inner, "inner"}},
                                 {{"type", "multipolygon"}, {"building", "yes"}, {"height", "12.34"}});
    const auto high =
        map.rectangle(40, 0, 50, 10, {{"building", "yes"}, {"height", "20"}, {"min_height", "5.5"}});
    const Model model = import(map.xml()).model;
    const std::string court = "building/relation-" + std::to_string(id);
    ASSERT_NE(find(model, court), nullptr);
    EXPECT_NEAR(plan_area(model, *find(model, court)), 60.0 * 40.0 - 20.0 * 20.0, 2.0);
    EXPECT_NEAR(bounds_of(model, court).max.y() - bounds_of(model, court).min.y(), 12.34, 0.01);
    EXPECT_NEAR(volume_of(model, court), 2000.0 * 12.34, 25.0);
    const std::string above = "building/way-" + std::to_string(high);
    EXPECT_NEAR(bounds_of(model, above).min.y(), 5.5, 0.01);
    EXPECT_NEAR(bounds_of(model, above).max.y(), 20.0, 0.01);
    EXPECT_NEAR(plan_area(model, *find(model, above), -1.0), 100.0, 0.1) << "it has an underside";
}

TEST_F(ImportMap, BuildsPartsInsteadOfTheirOutline) {
    MapText map;
    const auto outline =
        map.rectangle(0, 0, 20, 10, {{"building", "yes"}, {"height", "30"}, {"name", "Two parts"}});
    const auto low = map.rectangle(0, 0, 10, 10, {{"building:part", "yes"}, {"height", "6"}});
    const auto high = map.rectangle(10, 0, 20, 10, {{"building:part", "yes"}, {"height", "30"}});
    const Model model = import(map.xml()).model;
    const std::string name = "building/way-" + std::to_string(outline);
    EXPECT_EQ(find(model, name), nullptr);
    EXPECT_NEAR(volume_of(model, name + "/way-" + std::to_string(low)), 600.0, 1.0);
    EXPECT_NEAR(volume_of(model, name + "/way-" + std::to_string(high)), 3000.0, 3.0);
}

TEST_F(ImportMap, OpensAPassage) {
    MapText map;
    const auto id = map.rectangle(-10, -5, 10, 5, {{"building", "yes"}, {"height", "9"}});
    map.way({{0, -30}, {0, 30}}, {{"highway", "footway"}, {"tunnel", "building_passage"}, {"width", "3"}});
    const Model model = import(map.xml()).model;
    const std::string name = "building/way-" + std::to_string(id);
    EXPECT_NEAR(volume_of(model, name), 1800.0 - 3.0 * 10.0 * 2.7, 2.0);
    EXPECT_NEAR(plan_area(model, *find(model, name), -1.0), 30.0, 0.2) << "its ceiling";
}

TEST_F(ImportMap, OpensPassagesAsWideAndHighAsTheyAreTagged) {
    struct Case {
        MapText::Tags tags;
        double width;
        double height;
    };
    const std::vector<Case> cases = {{{}, 3.0, 2.7},
                                     {{{"width", "0.5"}}, 0.5, 2.7},
                                     {{{"width", "1"}, {"maxheight", "1.7"}}, 1.0, 1.7},
                                     {{{"width", "4"}, {"height", "3"}}, 4.0, 3.0},
                                     {{{"height", "3"}, {"maxheight", "2"}}, 3.0, 2.0}};
    for (const Case& each : cases) {
        MapText map;
        const auto id = map.rectangle(-10, -5, 10, 5, {{"building", "yes"}, {"height", "9"}});
        MapText::Tags tags = {{"highway", "footway"}, {"tunnel", "building_passage"}};
        tags.insert(tags.end(), each.tags.begin(), each.tags.end());
        map.way({{0, -30}, {0, 30}}, tags);
        const Model model = import(map.xml()).model;
        const std::string name = "building/way-" + std::to_string(id);
        EXPECT_NEAR(plan_area(model, *find(model, name), -1.0), 10.0 * each.width, 0.2);
        EXPECT_NEAR(volume_of(model, name), 1800.0 - 10.0 * each.width * each.height, 2.0);
    }
}

TEST_F(ImportMap, NamesLengthsThatItCannotRead) {
    MapText map;
    const auto id =
        map.rectangle(-10, -5, 10, 5, {{"building", "yes"}, {"height", "12-14"}, {"min_height", "low"}});
    map.way({{-40, -30}, {40, -30}}, {{"highway", "footway"}, {"width", "2 cubits"}});
    map.way({{-40, 30}, {40, 30}}, {{"highway", "footway"}, {"maxheight", "default"}, {"width", "3 m"}});
    const ImportedMap imported = import(map.xml());
    std::vector<std::string> messages;
    for (const Diagnostic& warning : imported.warnings) {
        if (warning.code == "unreadable-length") {
            messages.push_back(warning.message);
        }
    }
    ASSERT_EQ(messages.size(), 2U);
    EXPECT_TRUE(messages[0].starts_with("way-" + std::to_string(id) + ": height=12-14 ")) << messages[0];
    EXPECT_NE(messages[1].find("width=2 cubits"), std::string::npos) << messages[1];
}

TEST_F(ImportMap, DividesTheGroundWithoutGapsAndOverlaps) {
    MapText map;
    map.way({{-90, -80}, {0, 10}, {90, 15}}, {{"highway", "residential"}});
    map.way({{-80, 90}, {5, 0}, {60, -90}}, {{"highway", "footway"}});
    map.rectangle(-50, -50, 70, 60, {{"leisure", "park"}});
    map.rectangle(20, 20, 40, 40, {{"natural", "water"}});
    const ImportedMap imported = import(map.xml());
    double area = 0.0;
    Bounds bounds;
    for (const Node& node : imported.model.nodes) {
        if (!node.name.starts_with("water-surface")) {
            area += plan_area(imported.model, node);
            for_triangles(imported.model, node,
                          [&](const auto& a, const auto&, const auto&) { bounds.extend(a); });
        }
    }
    const Eigen::Vector3d size = bounds.max - bounds.min;
    EXPECT_GT(size.x(), 199.0);
    EXPECT_NEAR(area, size.x() * size.z(), 1e-4 * area);
}

TEST_F(ImportMap, KeepsNamesInTheirScriptAndIdsInAscii) {
    MapText map;
    const auto id = map.rectangle(0, 0, 20, 10,
                                  {{"building", "university"},
                                   {"name", "\xEB\x8F\x84\xEC\x84\x9C\xEA\xB4\x80 {x} &quot;&lt;b&gt;"},
                                   {"name:en", "Library"},
                                   {"opening_hours", "Mo-Fr 08:00-20:00"},
                                   {"building:levels", "4"}});
    const ImportedMap imported = import(map.xml());
    ASSERT_EQ(imported.draft.buildings.size(), 1U);
    EXPECT_EQ(imported.draft.buildings[0].id, "building-" + std::to_string(id));
    EXPECT_EQ(imported.draft.buildings[0].title, "\xEB\x8F\x84\xEC\x84\x9C\xEA\xB4\x80 {x} \"<b>");
    EXPECT_EQ(imported.draft.buildings[0].floors, 4);
    ASSERT_EQ(imported.draft.buildings[0].info.size(), 1U);
    EXPECT_EQ(imported.draft.buildings[0].info[0], std::pair(std::string("name-en"), std::string("Library")));
}

TEST_F(ImportMap, TakesHeightsFromLevels) {
    const auto top = [&](const MapText::Tags& tags) {
        MapText map;
        MapText::Tags all = {{"building", "yes"}};
        all.insert(all.end(), tags.begin(), tags.end());
        const auto id = map.rectangle(-10, -5, 10, 5, all);
        return bounds_of(import(map.xml()).model, "building/way-" + std::to_string(id)).max.y();
    };
    EXPECT_NEAR(top({{"building:levels", "4"}}), 12.0, 0.01);
    EXPECT_NEAR(top({{"building:levels", "0"}, {"roof:levels", "1"}, {"roof:shape", "gabled"}}), 3.0, 0.01);
    EXPECT_NEAR(top({{"building:levels", "2"}, {"roof:shape", "skillion"}, {"roof:angle", "30"}}),
                6.0 + 10.0 * std::tan(std::numbers::pi / 6.0), 0.02)
        << "over the whole breadth";
    EXPECT_NEAR(top({{"building:levels", "2"}, {"roof:shape", "gabled"}, {"roof:angle", "30"}}),
                6.0 + 5.0 * std::tan(std::numbers::pi / 6.0), 0.02)
        << "over half of it";
}

TEST_F(ImportMap, KeepsWhatIsBelowAPartOnTheRoof) {
    MapText map;
    const auto id = map.rectangle(-10, -5, 10, 5, {{"building", "yes"}, {"height", "10"}});
    map.rectangle(-5, -5, 5, 5, {{"building:part", "yes"}, {"height", "15"}, {"min_height", "10"}});
    const Model model = import(map.xml()).model;
    EXPECT_NEAR(volume_of(model, "building/way-" + std::to_string(id)), 2000.0, 2.0);
}

TEST_F(ImportMap, PavesAreasOfHighways) {
    MapText map;
    const auto outer = map.rectangle(-20, -20, 20, 20);
    const auto inner = map.rectangle(-5, -5, 5, 5);
    const auto id = map.relation({{outer, "outer"}, {inner, "inner"}},
                                 {{"type", "multipolygon"}, {"highway", "pedestrian"}});
    const Model model = import(map.xml()).model;
    const std::string name = "pedestrian/relation-" + std::to_string(id);
    ASSERT_NE(find(model, name), nullptr);
    EXPECT_NEAR(plan_area(model, *find(model, name)), 1500.0, 1.5);
}

TEST_F(ImportMap, KeepsElementsOfOneNumberApart) {
    const MapText::Tags hall = {{"building", "yes"}, {"name", "Hall"}};
    MapText map;
    map.rectangle(0, 10, 20, 20, hall);
    const auto outer = map.rectangle(0, -20, 20, -10);
    map.relation({{outer, "outer"}}, {{"type", "multipolygon"}, {"building", "yes"}, {"name", "Hall"}});
    map.way({{-50, 0}, {50, 0}}, {{"highway", "footway"}});
    std::string xml = map.xml();
    const auto renumber = [&](const std::string& element) {
        const auto at = xml.find("<" + element + " id=\"", xml.find("<" + element)) + element.size() + 6;
        xml.replace(at, xml.find('"', at) - at, "777");
    };
    renumber("way");
    renumber("relation");
    const ImportedMap imported = import(xml);
    std::set<std::string> names;
    for (const DraftPlace& place : imported.draft.places) {
        EXPECT_TRUE(names.insert(place.name).second) << place.name;
    }
    EXPECT_EQ(names.size(), 2U);
}

TEST_F(ImportMap, FindsDoorsAndPlacesInFrontOfThem) {
    MapText map;
    const auto door = map.node(10, 0, {{"entrance", "main"}});
    map.way_of({map.node(0, 0), door, map.node(20, 0), map.node(20, 10), map.node(0, 10), 2},
               {{"building", "yes"}, {"name", "Hall"}});
    const ImportedMap imported = import(map.xml());
    ASSERT_EQ(imported.draft.places.size(), 1U);
    EXPECT_EQ(imported.draft.places[0].name, "entrance-" + std::to_string(door));
    EXPECT_NEAR(imported.draft.places[0].at.x(), 10.0, 0.01);
    EXPECT_NEAR(imported.draft.places[0].at.z(), 1.0, 0.01) << "a metre to the south";
}

TEST_F(ImportMap, FindsDoorsAtWallsNearEntrances) {
    MapText map;
    map.rectangle(0, 0, 20, 10, {{"building", "yes"}, {"name", "Hall"}});
    const auto beside = map.node(5, -0.8, {{"entrance", "yes"}});
    const auto inside = map.node(15, 1.5, {{"entrance", "yes"}});
    map.node(10, 0, {{"entrance", "yes"}, {"level", "2"}});
    map.node(60, 60, {{"entrance", "yes"}});
    const ImportedMap imported = import(map.xml());
    EXPECT_EQ(
        std::ranges::count(imported.warnings, DiagnosticCode("entrance-without-wall"), &Diagnostic::code), 1);
    ASSERT_EQ(imported.draft.places.size(), 2U) << "not that of another floor";
    for (const DraftPlace& place : imported.draft.places) {
        EXPECT_NEAR(place.at.z(), 1.0, 0.01) << "a metre in front of the wall";
        EXPECT_TRUE(place.name == "entrance-" + std::to_string(beside) ||
                    place.name == "entrance-" + std::to_string(inside));
    }
}

TEST_F(ImportMap, TakesNamesInLanguagesOnly) {
    MapText map;
    map.rectangle(0, 0, 20, 10,
                  {{"building", "yes"},
                   {"name", "Hall"},
                   {"name:en", "The Hall"},
                   {"name:zh-Hant", "x"},
                   {"name:etymology:wikidata", "Q42"},
                   {"name:signed", "no"}});
    const DraftBuilding hall = import(map.xml()).draft.buildings.front();
    ASSERT_EQ(hall.info.size(), 2U);
    EXPECT_EQ(hall.info[0].first, "name-en");
    EXPECT_EQ(hall.info[1].first, "name-zh-hant");
}

TEST_F(ImportMap, BuildsFlightsWithTheirTreads) {
    MapText map;
    const auto id = map.way(
        {{0, 0}, {0, 6}}, {{"highway", "steps"}, {"step_count", "15"}, {"width", "2"}, {"handrail", "yes"}});
    const Model model = import(map.xml()).model;
    const std::string name = "steps/way-" + std::to_string(id);
    ASSERT_NE(find(model, name), nullptr);
    std::set<int> treads;
    for_triangles(model, *find(model, name), [&](const auto& a, const auto& b, const auto& c) {
        if (a.y() == b.y() && b.y() == c.y() && (b - a).cross(c - a).y() > 0.1) {
            treads.insert(static_cast<int>(std::lround(1000.0 * a.y())));
        }
    });
    EXPECT_EQ(treads.size(), 15U);
    EXPECT_GT(*treads.rbegin(), 1500) << "15 risers of about 16 cm";
}

TEST_F(ImportMap, RefusesWhatIsNoMap) {
    EXPECT_EQ(refusal("not a map at all"), "bad-map");
    EXPECT_EQ(refusal(""), "bad-map");
    EXPECT_EQ(refusal("<osm version=\"0.6\"><node id=\"1\" lat=\"1\" lon=\"1\">"), "bad-map");
    EXPECT_EQ(
        refusal(
            "<?xml version=\"1.0\"?><!DOCTYPE a [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;\">]>"
            "<osm version=\"0.6\"><node id=\"1\" lat=\"1\" lon=\"1\"><tag k=\"&b;\" v=\"1\"/></node></osm>"),
        "bad-map");
    EXPECT_EQ(refusal("damaged", "a.pbf"), "bad-map");
    EXPECT_EQ(refusal("<osm version=\"0.6\"></osm>"), "bad-size");
    EXPECT_EQ(refusal("<osm version=\"0.6\"><node id=\"1\" lat=\"1\" lon=\"1\"/></osm>"), "bad-size");
    EXPECT_EQ(refusal("<osm version=\"0.6\"><node id=\"1\" lat=\"1\" lon=\"1\"/><node id=\"2\" lat=\"80\" "
                      "lon=\"170\"/></osm>"),
              "bad-size");
}

TEST_F(ImportMap, SurvivesWhatMapsGetWrong) {
    MapText map;
    map.way({{0, 0}, {10, 0}, {10, 10}}, {{"building", "yes"}, {"name", "open"}});
    map.ring({{0, 20}, {10, 30}, {10, 20}, {0, 30}}, {{"building", "yes"}, {"height", "-5"}});  // a bow
    map.ring({{0, 40}, {10, 40}, {20, 40}}, {{"building", "yes"}});                             // no area
    map.way_of({1, 1, 1}, {{"highway", "footway"}});
    map.way_of({7777}, {{"highway", "steps"}});
    map.relation({{7777, "outer"}}, {{"type", "multipolygon"}, {"building", "yes"}});
    map.rectangle(-50, -50, -40, -40,
                  {{"building", "yes"},
                   {"height", "1e308"},
                   {"building:levels", "-3"},
                   {"min_height", "99999"},
                   {"roof:shape", "onion"},
                   {"roof:height", "1e9"}});
    map.way({{-60, -60}, {60, 60}}, {{"highway", "footway"}, {"width", "0"}});
    map.way({{-60, 60}, {60, -60}}, {{"highway", "steps"}, {"step_count", "999999999"}, {"width", "1e9"}});
    for (const char* key : {"building:levels", "building:min_level"}) {
        map.rectangle(60, -60, 70, -50, {{"building", "yes"}, {key, "1000000000"}});
        map.rectangle(60, -40, 70, -30, {{"building", "yes"}, {key, "2019"}});
    }
    const ImportedMap imported = import(map.xml());
    EXPECT_TRUE(test::has_code(imported.warnings, "open-ring"));
    EXPECT_EQ(std::ranges::count(imported.warnings, DiagnosticCode("odd-levels"), &Diagnostic::code), 5);
    for (const Mesh& mesh : imported.model.meshes) {
        for (const Eigen::Vector3f& p : mesh.positions) {
            ASSERT_TRUE(p.allFinite()) << mesh.name;
            ASSERT_LT(p.norm(), 2000.0F) << mesh.name;
        }
    }
}

/// In the plan, of the faces that face up with nothing above them: not the floors of passages.
double roof_area(const Model& model, const Node& node) {
    if (plan_area(model, node, -1.0) == 0.0) {
        return plan_area(model, node);
    }
    double area = 0.0;
    for_triangles(model, node, [&](const auto& a, const auto& b, const auto& c) {
        const Eigen::Vector3d middle = (a + b + c) / 3.0;
        const double top = top_at(model, middle.x(), -middle.z(), node.name);
        area += middle.y() > top - 0.01 ? std::max(0.0, 0.5 * (b - a).cross(c - a).y()) : 0.0;
    });
    return area;
}

class RealMaps : public testing::TestWithParam<const char*> {};

/// Every area of the map with a flat roof is that of its roof, to a thousandth.
TEST_P(RealMaps, KeepTheAreasOfTheirBuildings) {
    const std::filesystem::path file = std::filesystem::path(CAMPUSWALK_SHARED_DATA) / "osm" / GetParam();
    if (!std::filesystem::exists(file)) {
        GTEST_SKIP() << file << " isn't there";
    }
    MapRequest request;
    request.file = file;
    request.mark.file = GetParam();
    const ImportedMap imported = import_map(request);
    DiagnosticList ignored;
    const Map map = read_map(file, request.mark, {}, ignored);
    std::size_t checked = 0;
    for (const MapWay& way : map.ways) {
        const Node* node = find(imported.model, "building/way-" + std::to_string(way.id));
        if (node == nullptr || !way.closed() || way.tags.is("building", "roof")) {
            continue;
        }
        double twice = 0.0;  // the shoelace formula on the projected nodes
        for (std::size_t i = 1; i < way.points.size(); ++i) {
            twice += way.points[i - 1].x() * way.points[i].y() - way.points[i].x() * way.points[i - 1].y();
        }
        const bool has_parts = std::ranges::any_of(imported.model.nodes, [&](const Node& other) {
            return other.name.starts_with(node->name + "/");
        });
        if (!has_parts) {
            const double area = roof_area(imported.model, *node);
            EXPECT_NEAR(area, 0.5 * std::abs(twice), 0.001 * 0.5 * std::abs(twice)) << node->name;
            ++checked;
        }
    }
    EXPECT_GT(checked, 40U);
}

std::string name_of(const testing::TestParamInfo<const char*>& map) {
    const std::string name = map.param;
    return name.substr(0, name.find('.'));
}

INSTANTIATE_TEST_SUITE_P(Maps, RealMaps, testing::Values("tum.osm", "brown.osm", "ajou.osm", "quito.osm"),
                         name_of);

}  // namespace
}  // namespace campuswalk::scene::osm
