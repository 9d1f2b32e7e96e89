#include "scene/osm/read/read_map.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/scene/osm/imported_map.h"

namespace campuswalk::scene::osm {
namespace {

using test::MapText;

class ReadMap : public testing::Test {
protected:
    Map read(const std::string& xml, const MapSection& section = {}) {
        folder_.write("a.osm", xml);
        return read_map(folder_.path() / "a.osm", mark_, section, warnings_);
    }
    std::vector<std::int64_t> ids_of_ways(const Map& map) {
        std::vector<std::int64_t> ids;
        for (const MapWay& way : map.ways) {
            ids.push_back(way.id);
        }
        return ids;
    }

    test::TemporaryFolder folder_;
    SourceMark mark_{"a.osm", 0, 0};
    DiagnosticList warnings_;
};

/// The square of 100 m about the middle of what MapText writes.
MapSection middle() {
    MapSection section;
    section.center = {48.0, 11.0};
    section.radius = 50.0;
    return section;
}

TEST_F(ReadMap, KeepsWholeOfASectionOnlyWhatOverlapsIt) {
    MapText map(8000.0);
    const auto inside = map.way({{-10, 0}, {10, 0}}, {{"highway", "footway"}});
    const auto crossing = map.way({{-3000, 20}, {3000, 20}}, {{"highway", "primary"}});  // no node is near
    const auto around = map.rectangle(-2000, -2000, 2000, 2000, {{"landuse", "grass"}});
    map.way({{1000, 1000}, {2000, 1500}}, {{"highway", "footway"}});
    const auto begins = map.way({{0, 30}, {5000, 30}}, {{"highway", "track"}});
    map.node(10, 10, {{"natural", "tree"}});
    map.node(900, 10, {{"natural", "tree"}});
    // A lake whose far shore is a way of its own.
    const auto near_shore = map.way({{-40, -40}, {40, -40}});
    const auto far_shore = map.way({{40, -40}, {40, -4000}, {-40, -4000}, {-40, -40}});
    map.relation({{near_shore, "outer"}, {far_shore, "outer"}},
                 {{"type", "multipolygon"}, {"natural", "water"}});
    const auto other = map.way({{3000, 3000}, {3100, 3000}});
    map.relation({{other, "outer"}}, {{"type", "multipolygon"}, {"natural", "water"}});

    const Map part = read(map.xml(), middle());
    EXPECT_EQ(ids_of_ways(part), (std::vector{inside, crossing, around, begins, near_shore, far_shore}));
    for (const MapWay& way : part.ways) {
        EXPECT_TRUE(way.complete) << way.id;
    }
    EXPECT_EQ(part.nodes.size(), 1U);
    EXPECT_EQ(part.relations.size(), 1U);
    EXPECT_NEAR(part.way(begins)->points.back().x(), 5000.0, 1.0);
    EXPECT_TRUE(warnings_.all().empty());
}

TEST_F(ReadMap, TakesFilesInAnyOrder) {
    MapText map(1000.0);
    map.way({{-10, 0}, {10, 0}}, {{"highway", "footway"}});
    const auto building = map.rectangle(-30, 10, -10, 30, {{"building", "yes"}});
    const std::string xml = map.xml();
    // Ways before nodes.
    const std::size_t first_node = xml.find(" <node");
    const std::size_t first_way = xml.find(" <way");
    const std::size_t end = xml.rfind("</osm>");
    const std::string turned = xml.substr(0, first_node) + xml.substr(first_way, end - first_way) +
                               xml.substr(first_node, first_way - first_node) + xml.substr(end);
    const Map whole = read(turned, middle());
    EXPECT_EQ(whole.ways.size(), 2U);
    ASSERT_NE(whole.way(building), nullptr);
    EXPECT_TRUE(whole.way(building)->complete);
}

TEST_F(ReadMap, LeavesOutWhatTheDatabaseForbids) {
    MapText map;
    MapText::Points many;
    for (int i = 0; i < 2001; ++i) {
        many.emplace_back(-90.0 + 0.09 * i, 0.0);
    }
    const auto too_long = map.way(many, {{"highway", "footway"}});
    many.pop_back();
    const auto longest = map.way(many, {{"highway", "footway"}});
    map.node(1, 1,
             {{"name", "\xE2\x80\x8B \xE2\x80\xAE"}, {"ref", std::string(300, 'x')}, {"shop", "kiosk"}});
    const Map read_back = read(map.xml());
    EXPECT_EQ(read_back.way(too_long), nullptr);
    EXPECT_NE(read_back.way(longest), nullptr);
    ASSERT_TRUE(test::has_code(warnings_.all(), "oversized-element"));
    EXPECT_NE(warnings_.all()[0].message.find("way-" + std::to_string(too_long)), std::string::npos);
    ASSERT_EQ(read_back.nodes.size(), 1U);
    EXPECT_FALSE(read_back.nodes[0].tags.has("name")) << "nobody sees it";
    EXPECT_EQ(read_back.nodes[0].tags.get("ref").size(), 255U);
}

TEST_F(ReadMap, TakesTheFormatFromTheGivenName) {
    MapText map;
    map.way({{-10, 0}, {10, 0}}, {{"highway", "footway"}});
    folder_.write("abc123", map.xml());
    mark_.file = "campus.osm";
    EXPECT_EQ(read_map(folder_.path() / "abc123", mark_, {}, warnings_).ways.size(), 1U);
    mark_.file = "campus.osm.pbf";
    const auto errors = test::errors_of([&] { read_map(folder_.path() / "abc123", mark_, {}, warnings_); });
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].code.text(), "bad-map");
}

/// A footway, and what else is in the file.
std::string with_footway(const std::string& more) {
    return R"(<osm version="0.6"><node id="1" version="2" lat="48" lon="11"/><node id="2" lat="48.001" lon="11.001"/>)"
           R"(<way id="3" version="5"><nd ref="1"/><nd ref="2"/><tag k="highway" v="footway"/></way>)" +
           more + "</osm>";
}

TEST_F(ReadMap, LeavesOutWhatIsDeleted) {
    const Map map = read(with_footway(R"(
        <node id='4' action='delete' lat='48' lon='11'><tag k='barrier' v='block'/></node>
        <node id='5' action='delete' version='1'/>
        <way id='6' action="delete" version='1'><nd ref='1'/><nd ref='2'/><tag k='highway' v='path'/></way>
        <way id='7' visible='false' version='2'><nd ref='1'/><nd ref='2'/><tag k='highway' v='path'/></way>
        <way id='-8' action='modify'><nd ref='1'/><nd ref='2'/><tag k='note' v=" action='delete'"/></way>
        <relation id='9' version='1' action='delete'><member type='way' ref='3' role='outer'/>
        <tag k='type' v='multipolygon'/></relation>)"));
    EXPECT_EQ(ids_of_ways(map), (std::vector<std::int64_t>{-8, 3}));
    EXPECT_TRUE(map.nodes.empty());
    EXPECT_TRUE(map.relations.empty());
    EXPECT_TRUE(warnings_.all().empty()) << "the deleted node has no coordinates";
}

TEST_F(ReadMap, FindsWhatIsDeletedFarInTheFile) {
    for (int spaces = 1 << 20; spaces > (1 << 20) - 600; spaces -= 100) {  // where pieces of the file meet
        const Map map = read(with_footway("<!--" + std::string(static_cast<std::size_t>(spaces), ' ') +
                                          "--><way id='6' action='delete'><nd ref='1'/><nd ref='2'/></way>"));
        EXPECT_EQ(ids_of_ways(map), (std::vector<std::int64_t>{3}));
    }
}

/// Wherever it is in the file, and also in a section.
TEST_F(ReadMap, TakesTheHighestVersion) {
    const auto edition = [](int version, const std::string& value) {
        return "<way id='4' version='" + std::to_string(version) +
               "'><nd ref='1'/><nd ref='2'/><tag k='highway' v='" + value + "'/></way>";
    };
    const std::string other = "<way id='9'><nd ref='1'/><nd ref='2'/></way>";
    for (const std::string& text :
         {edition(1, "path") + edition(2, "steps"), edition(2, "steps") + edition(1, "path"),
          edition(2, "steps") + other + edition(1, "path"),
          edition(1, "path") + edition(1, "track") + other + edition(2, "steps") + edition(2, "steps"),
          "<node id='1' version='1' lat='1' lon='1'/>" + edition(2, "steps")}) {
        for (const MapSection& section : {MapSection(), middle()}) {
            const Map map = read(with_footway(text), section);
            ASSERT_NE(map.way(4), nullptr) << text;
            EXPECT_EQ(map.way(4)->tags.get("highway"), "steps") << text;
            EXPECT_EQ(std::ranges::count(ids_of_ways(map), 4), 1);
        }
    }
    EXPECT_EQ(read(with_footway(edition(1, "path") + "<way id='4' version='2' visible='false'/>")).way(4),
              nullptr);
    EXPECT_EQ(read(with_footway("<way id='4' version='2' action='delete'/>" + edition(1, "path"))).way(4),
              nullptr);
    EXPECT_NE(read(with_footway("<way id='4' version='2' action='delete'/>" + edition(3, "path"))).way(4),
              nullptr);
}

TEST_F(ReadMap, WarnsOfDifferentContentsOfOneVersion) {
    const std::string skeleton = "<way id='4'><nd ref='1'/><nd ref='2'/></way>";
    const std::string full = "<way id='4'><nd ref='1'/><nd ref='2'/><tag k='highway' v='path'/></way>";
    const std::string longer =
        "<way id='4'><nd ref='1'/><nd ref='2'/><nd ref='1'/><tag k='highway' v='steps'/></way>";
    for (const auto& [text, value] : {std::pair{skeleton + full, "path"},
                                      {full + skeleton, "path"},
                                      {full + longer + skeleton, "steps"}}) {
        warnings_ = {};
        EXPECT_EQ(read(with_footway(text)).way(4)->tags.get("highway"), value);
        ASSERT_TRUE(test::has_code(warnings_.all(), "ambiguous-element"));
        EXPECT_NE(warnings_.all()[0].message.find("way-4 is in the file more than once"), std::string::npos);
    }
    warnings_ = {};
    read(with_footway(full + full));
    read(with_footway(skeleton + full + "<way id='4' version='1'><nd ref='1'/><nd ref='2'/></way>"));
    EXPECT_TRUE(warnings_.all().empty()) << "equal, or a higher version";
}

/// A map of Taveuni, which the antimeridian divides.
MapText across_the_antimeridian() {
    MapText map(100.0, -16.8, 180.0);
    map.way({{-80, 0}, {80, 0}}, {{"highway", "footway"}});
    map.rectangle(-20, 10, 30, 30, {{"building", "yes"}, {"name", "Meridian Hall"}});
    map.node(50, -10, {{"natural", "tree"}});
    return map;
}

TEST_F(ReadMap, TakesMapsAcrossTheAntimeridian) {
    const std::string xml = across_the_antimeridian().xml();
    const auto bounds = xml.find(" <bounds");
    std::string unbounded = xml;
    unbounded.erase(bounds, xml.find('\n', bounds) - bounds);
    MapSection box;
    box.box = GeographicBox{-16.801, 179.999, -16.799, 180.001};
    MapSection square;
    square.center = {-16.8, -180.0};
    square.radius = 100.0;
    for (const auto& [text, section] :
         {std::pair{xml, MapSection()}, {unbounded, MapSection()}, {xml, box}, {xml, square}}) {
        const Map map = read(text, section);
        EXPECT_LT(map.box.size().x(), 215.0);
        ASSERT_EQ(map.ways.size(), 2U);
        EXPECT_NEAR(map.ways[0].points[1].x() - map.ways[0].points[0].x(), 160.0, 0.1);
        EXPECT_EQ(map.nodes.size(), 1U);
    }
    EXPECT_TRUE(warnings_.all().empty());
}

TEST_F(ImportMap, IsTheSameAcrossTheAntimeridianAsElsewhere) {
    const ImportedMap across = import(across_the_antimeridian().xml());
    EXPECT_NEAR(std::abs(across.draft.longitude_deg), 180.0, 1e-6);
    EXPECT_NEAR(plan_area(across.model, across.model.nodes[0]), 200.0 * 200.0, 500.0);
    ASSERT_EQ(across.draft.buildings.size(), 1U);
    EXPECT_FALSE(across.draft.places.empty());
}

TEST_F(ReadMap, RefusesALargeMapBeforeItIsRead) {
    std::string xml =
        "<osm version=\"0.6\"><bounds minlat=\"47\" minlon=\"10\" maxlat=\"48\" maxlon=\"11\"/>";
    for (int i = 1; i < 60'000; ++i) {
        xml += "<node id=\"" + std::to_string(i) + "\" lat=\"47.5\" lon=\"10.5\"/>\n";
    }
    const auto errors = test::errors_of([&] { read(xml + "</broken>"); });
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].code.text(), "bad-size");
}

/// Buildings of 4.9 km with 200 levels of windows would take gigabytes.
TEST_F(ImportMap, LimitsTheTrianglesOfAMap) {
    MapText map(9000.0);
    const auto hall =
        map.rectangle(-8900, -8900, -4000, -4000, {{"building", "yes"}, {"building:levels", "200"}});
    for (const double south : {-3000.0, 2000.0}) {
        for (const double west : {-8900.0, -3000.0, 3000.0}) {
            map.rectangle(west, south, west + 4800, south + 4800,
                          {{"building", "yes"}, {"building:levels", "200"}});
        }
    }
    const auto errors = test::errors_of([&] { import(map.xml()); });
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].code.text(), "bad-size");
    EXPECT_NE(errors[0].message.find("10 million triangles, of which building/way-" + std::to_string(hall) +
                                     " has "),
              std::string::npos)
        << errors[0].message;
    EXPECT_NE(errors[0].message.find("such as --center 48.000000,11.000000 --radius 450"), std::string::npos);
}

}  // namespace
}  // namespace campuswalk::scene::osm
