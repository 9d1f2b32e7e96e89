#include "config/loader/campus/read_places.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"
#include "tests/support/says.h"

namespace campuswalk::config {
namespace {

using scene::CampusDescription;
using scene::Place;
using support::says;
using test::Lines;
using testing::ElementsAre;

constexpr const char* kOnEarth = "origin: {latitude_deg: 48.15, longitude_deg: 11.57, height: 500}\n";

class ReadPlaces : public testing::Test {
protected:
    static std::string campus_with(const std::string& text) {
        return "scenes: [{file: a.obj}]\ncolliders: []\n" + text;
    }

    CampusDescription read(const std::string& text) {
        folder_.write("a.campus.yaml", campus_with(text));
        return folder_.campus();
    }
    Lines about(const std::string& text) { return folder_.about_campus(campus_with(text)); }
    /// The diagnostics of a file of places.
    Lines about_file(const std::string& geojson, const std::string& origin = kOnEarth) {
        folder_.write("p.geojson", geojson);
        return about("places: {from: p.geojson}\n" + origin);
    }

    static std::string point(const std::string& properties, const std::string& coordinates) {
        return R"({"type": "Feature", "properties": {)" + properties +
               R"(}, "geometry": {"type": "Point", "coordinates": )" + coordinates + "}}";
    }
    static std::string collection(const std::vector<std::string>& features, const std::string& members = "") {
        std::string text = R"({"type": "FeatureCollection", )" + members + "\"features\": [";
        for (std::size_t i = 0; i < features.size(); ++i) {
            text += (i == 0 ? "\n" : ",\n") + features[i];
        }
        return text + "]}";
    }

    test::ConfigFolder folder_;
};

std::vector<std::string> names_of(const CampusDescription& campus) {
    std::vector<std::string> names;
    for (const Place& place : campus.places) {
        names.push_back(place.name);
    }
    return names;
}

TEST_F(ReadPlaces, ReadsPointsOfTheEarth) {
    // East and north by PROJ 9.1: proj +proj=ortho +lat_0=48.15 +lon_0=11.57 +ellps=WGS84.
    folder_.write("p.geojson", collection({point(R"("name": "Audimax")", "[11.58, 48.16, 512.5]"),
                                           point(R"("name": "gate_A")", "[11.6, 48.1]")}));
    const CampusDescription campus =
        read(std::string(kOnEarth) + "places: {from: p.geojson, desk: [1, 2, 3]}\n");
    EXPECT_THAT(names_of(campus), ElementsAre("desk", "Audimax", "gate_A"));
    EXPECT_LT((campus.places[1].position - Eigen::Vector3d(743.943122, 12.5, -1111.981723)).norm(), 1e-5);
    EXPECT_TRUE(campus.places[1].has_height);
    EXPECT_NEAR(campus.places[2].position.x(), 2234.430546, 1e-5);
    EXPECT_NEAR(campus.places[2].position.z(), 5559.201232, 1e-5);
    EXPECT_FALSE(campus.places[2].has_height);
    EXPECT_EQ(campus.places[2].mark.file, folder_.path("p.geojson").string());
    EXPECT_EQ(campus.places[2].mark.line, 3);
    EXPECT_THAT(campus.place_files, ElementsAre(folder_.path("p.geojson")));
}

TEST_F(ReadPlaces, ReadsMetresOfTheCampus) {
    const std::string file = collection({point(R"("ref": 101, "floor": "2")", "[4, 8, 3.5]"),
                                         point(R"("ref": "101b", "floor": 1)", "[4, 8]")});
    folder_.write("rooms.json", file);
    CampusDescription campus =
        read("places:\n  from: {file: rooms.json, name: ref, coordinates: campus, height: 7}\n");
    EXPECT_THAT(names_of(campus), ElementsAre("101", "101b"));
    EXPECT_EQ(campus.places[0].position, Eigen::Vector3d(4, 3.5, -8));
    EXPECT_EQ(campus.places[1].position, Eigen::Vector3d(4, 7, -8));
    EXPECT_TRUE(campus.places[1].has_height);
    campus = read(
        "places:\n  from: [{file: rooms.json, name: ref, coordinates: campus, where: {floor: [1, 3]}}]\n");
    EXPECT_THAT(names_of(campus), ElementsAre("101b"));
    // explore says so in the file itself.
    folder_.write("rooms.json", collection({point(R"("name": "a")", "[4, 8]")},
                                           R"("coordinates": "metres: x, -z, height", )"));
    EXPECT_EQ(read("places: {from: rooms.json}\n").places.at(0).position.z(), -8.0);
    EXPECT_THAT(about("places: {from: {file: rooms.json, coordinates: geographic}}\n"),
                ElementsAre(says("rooms.json:1:46: error bad-value", {"metres"})));
}

TEST_F(ReadPlaces, MakesIdsOfNames) {
    std::vector<std::string> features;
    for (const char* name :
         {"Room A.101 (lab)", "图文信息中心", "building_A", "Café Ä", "door", "door", "Door!"}) {
        features.push_back(point("\"name\": \"" + std::string(name) + "\"", "[0, 0, 0]"));
    }
    folder_.write("p.geojson", collection(features, R"("coordinates": "metres", )"));
    const CampusDescription campus = read("places: {from: [p.geojson, p.geojson], door-2: [0, 0, 0]}\n");
    EXPECT_THAT(names_of(campus),
                ElementsAre("door-2", "room-a-101-lab", "图文信息中心", "building_A", "café-ä", "door",
                            "door-3", "door-4", "room-a-101-lab-2", "图文信息中心-2", "building_A-2",
                            "café-ä-2", "door-5", "door-6", "door-7"));
    for (const char* name : {"...", "\\u2192"}) {
        EXPECT_THAT(
            about_file(collection({point("\"name\": \"" + std::string(name) + "\"", "[11.57, 48.15]")})),
            ElementsAre(says("p.geojson:2:1: error bad-value", {"neither letters nor digits"})));
    }
    EXPECT_THAT(
        about_file(collection({point("\"name\": \"" + std::string(201, 'a') + "\"", "[11.57, 48.15]")})),
        ElementsAre(says("p.geojson:2:1: error bad-value", {"too long"})));
}

TEST_F(ReadPlaces, APlaceMayBeCalledFrom) {
    const CampusDescription campus = read("places: {from: [1, 2, 3]}\n");
    EXPECT_THAT(names_of(campus), ElementsAre("from"));
    EXPECT_EQ(campus.places[0].position, Eigen::Vector3d(1, 2, 3));
}

TEST_F(ReadPlaces, LeavesOutWhatIsNoPlaceNearby) {
    folder_.write(
        "p.geojson",
        collection({R"({"type": "Feature", "properties": {"name": "Hall"}, "geometry":
                                  {"type": "Polygon", "coordinates": [[[11, 48], [12, 48], [12, 49], [11, 48]]]}})",
                    R"({"type": "Feature", "properties": {"name": "nowhere"}, "geometry": null})",
                    R"({"type": "Feature", "properties": null, "geometry": null})",
                    point(R"("kind": "stuck")", "[11.57, 48.15]"), point(R"("name": null)", "[11.57, 48.15]"),
                    point(R"("name": "")", "[11.57, 48.15]"), point(R"("name": "swapped")", "[48.15, 11.57]"),
                    point(R"("name": "antipode")", "[-168.43, -48.15]"),
                    point(R"("name": "here")", "[11.57, 48.15]")}));
    const CampusDescription campus = read(std::string(kOnEarth) + "places: {from: p.geojson}\n");
    EXPECT_THAT(names_of(campus), ElementsAre("here"));
    ASSERT_EQ(campus.warnings.size(), 3U);
    EXPECT_THAT(
        scene::to_string(campus.warnings[0]),
        says(folder_.path("p.geojson").string() + ":5:1: warning unnamed-feature", {"4 features", "'name'"}));
    EXPECT_THAT(
        scene::to_string(campus.warnings[1]),
        says(folder_.path("p.geojson").string() + ":2:1: warning not-a-point", {"2 features", "'Hall'"}));
    EXPECT_THAT(
        scene::to_string(campus.warnings[2]),
        says(folder_.path("p.geojson").string() + ":9:1: warning far-place", {"2 features", "'swapped'"}));
}

TEST_F(ReadPlaces, DiagnosesTheFile) {
    const std::string good = point(R"("name": "a")", "[11.57, 48.15]");
    EXPECT_THAT(about("places: {from: none.geojson}\n"),
                ElementsAre(says("a.campus.yaml:3:16: error missing-file", {"none.geojson"})));
    EXPECT_THAT(about("places: {from: ../p.geojson}\n"),
                ElementsAre(says("a.campus.yaml:3:16: error outside-project")));
    EXPECT_THAT(about("places: {from: {name: ref}}\n"),
                ElementsAre(says("a.campus.yaml:3:16: error missing-key", {"'file'"})));
    EXPECT_THAT(about("places: {from: [p.geojson, {file: p.geojson, nmae: ref}]}\n").back(),
                says("a.campus.yaml:3:46: error unknown-key", {"'nmae'", "'name'"}));
    EXPECT_THAT(
        about_file(collection({good}), ""),
        ElementsAre(says("a.campus.yaml:3:16: error no-origin", {"latitude_deg", "coordinates: campus"})));
    EXPECT_THAT(about_file("[]"), ElementsAre(says("p.geojson:1:1: error wrong-type", {"map"})));
    EXPECT_THAT(about_file("{}"), ElementsAre(says("p.geojson:1:1: error missing-key", {"'type'"})));
    EXPECT_THAT(about_file(R"({"type": "Topology"})"),
                ElementsAre(says("p.geojson:1:10: error bad-value", {"'Topology'"})));
    EXPECT_THAT(about_file(R"({"type": "FeatureCollection"})"),
                ElementsAre(says("p.geojson:1:1: error missing-key", {"'features'"})));
    EXPECT_THAT(about_file(R"({"type": "FeatureCollection", "features": {}})"),
                ElementsAre(says("p.geojson:1:43: error wrong-type", {"list"})));
    EXPECT_THAT(about_file(collection({"7", good})), ElementsAre(says("p.geojson:2:1: error wrong-type")));
    EXPECT_THAT(
        about_file(collection({point(R"("name": "a")", "[11.57, 91]"), point(R"("name": "b")", "[11.57]"),
                               point(R"("name": "c")", "[\"11\", 48]"), point(R"("name": "d")", "7"),
                               point(R"("name": {})", "[11.57, 48.15]"),
                               point(R"("name": "f")", "[11.57, 48.15, null]")})),
        ElementsAre(says("p.geojson:2:103: error bad-value", {"from -90 to 90 degrees"}),
                    says("p.geojson:3:95: error bad-value", {"[longitude, latitude]"}),
                    says("p.geojson:4:96: error wrong-type", {"number"}),
                    says("p.geojson:5:95: error wrong-type", {"list"}),
                    says("p.geojson:6:44: error wrong-type", {"'name'"}),
                    says("p.geojson:7:110: error wrong-type", {"number"})));
    EXPECT_THAT(
        about_file(R"({"type": "Feature", "properties": {"name": "a"}, "geometry": {"type": "Circle"}})"),
        ElementsAre(says("p.geojson:1:71: error bad-value", {"'Circle'"})));
    EXPECT_THAT(about_file(collection({good}, R"("crs": {"properties": {"name": "EPSG:31468"}}, )")),
                ElementsAre(says("p.geojson:1:38: error bad-crs", {"WGS 84"})));
    EXPECT_THAT(about_file(collection(
                    {good}, R"("crs": {"properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}}, )")),
                ElementsAre());
    EXPECT_THAT(about_file(collection({point(R"("ref": "a", "floor": 1)", "[11.57, 48.15]")})),
                ElementsAre(says("a.campus.yaml:3:16: error no-places", {"'name'", "floor, ref"})));
    EXPECT_THAT(about_file("{\"type\": \"Feature\",\n\"properties\": {"),
                ElementsAre(says("p.geojson:2:15: error json-syntax")));
    EXPECT_THAT(about_file(std::string(8'000'001, ' ')), ElementsAre(says("p.geojson: error too-large")));
}

TEST_F(ReadPlaces, LimitsTheirNumber) {
    std::vector<std::string> features(20'001, point(R"("name": "a")", "[0, 0]"));
    folder_.write("p.geojson", collection(features, R"("coordinates": "metres", )"));
    EXPECT_THAT(about("places: {from: p.geojson}\n"),
                ElementsAre(says("a.campus.yaml:3:16: error too-large", {"20000"})));
    features.pop_back();
    folder_.write("p.geojson", collection(features, R"("coordinates": "metres", )"));
    const CampusDescription campus = read("places: {from: p.geojson}\n");
    EXPECT_EQ(campus.places.back().name, "a-20000");
}

TEST_F(ReadPlaces, WalksGoToThem) {
    folder_.write("p.geojson", collection({point(R"("name": "high")", "[4, 8, 3.5]"),
                                           point(R"("name": "flat")", "[4, 8]")},
                                          R"("coordinates": "metres", )"));
    folder_.write("a.campus.yaml",
                  campus_with("spawns: {gate: {at: [0, 0, 0]}}\nplaces: {from: p.geojson}\n"));
    folder_.write("a.walk.yaml",
                  "campus: a.campus.yaml\nsteps: [{spawn: gate}, {go_to: high}, {go_to: flat}]\n");
    const auto run = folder_.run();
    const auto& high = std::get<engine::GoToStep>(run.walk.steps.at(1)).target;
    const auto& flat = std::get<engine::GoToStep>(run.walk.steps.at(2)).target;
    EXPECT_EQ(high.point, Eigen::Vector3d(4, 3.5, -8));
    EXPECT_TRUE(high.has_height);
    EXPECT_EQ(flat.point, Eigen::Vector3d(4, 0, -8));
    EXPECT_FALSE(flat.has_height);
    EXPECT_THAT(folder_.about_steps("  - spawn: gate\n  - go_to: nigh\n"),
                ElementsAre(says("a.walk.yaml:4:12: error unknown-name", {"'high'"})));
    EXPECT_THAT(
        folder_.about_steps("  - spawn: gate\n  - snapshot: {name: s, view: fixed, position: [0, 0, 0], "
                            "look_at: flat}\n"),
        ElementsAre(says("a.walk.yaml:4:68: error bad-value", {"height", "'flat'"})));
}

}  // namespace
}  // namespace campuswalk::config
