#include "config/loader/campus/read_campus.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"
#include "tests/support/says.h"

namespace campuswalk::config {
namespace {

using scene::CampusDescription;
using scene::UpAxis;
using support::says;
using test::Lines;
using testing::ElementsAre;

class ReadCampus : public testing::Test {
protected:
    /// The diagnostics of a campus with these lines and the required keys.
    Lines about(const std::string& text) {
        return folder_.about_campus("scenes: [{file: a.obj}]\ncolliders: []\n" + text);
    }

    CampusDescription read(std::string_view text) {
        folder_.write("a.campus.yaml", text);
        return folder_.campus();
    }

    test::ConfigFolder folder_;
};

TEST_F(ReadCampus, ReadsEveryKey) {
    const CampusDescription campus = read(R"(
scenes:
  - {file: models/a.obj, up: z, unit: cm, scale: 2.5, position: [1, -2, 3]}
  - {file: b.glb}
layers: [ground, street-furniture]
buildings:
  - id: main-library
    nodes: ["library", "library_*"]
    title: Main Library
    kind: library
    text: "Four floors.\nQuiet."
    hours: "08-22"
    floors: 4
  - {id: hut, nodes: hut, title: Hut}
colliders:
  - {id: ground, nodes: terrain, shape: mesh, mode: solid}
spawns:
  gate: {at: [0, 1.5, 24], yaw_deg: -90}
  square: {at: [1, 2, 3]}
places:
  door: [4, 5, -6]
)");
    EXPECT_EQ(campus.name, "a");
    ASSERT_EQ(campus.scenes.size(), 2U);
    EXPECT_EQ(campus.scenes[0].file, "models/a.obj");
    EXPECT_EQ(campus.scenes[0].path, folder_.path("models/a.obj"));
    EXPECT_EQ(campus.scenes[0].up, UpAxis::z);
    EXPECT_EQ(campus.scenes[0].metres_per_unit, 0.01);
    EXPECT_EQ(campus.scenes[0].scale, 2.5);
    EXPECT_EQ(campus.scenes[0].position, Eigen::Vector3d(1, -2, 3));
    EXPECT_EQ(campus.scenes[0].mark.line, 3);
    EXPECT_EQ(campus.scenes[0].mark.column, 12);
    EXPECT_EQ(campus.scenes[1].up, UpAxis::y);
    EXPECT_EQ(campus.scenes[1].metres_per_unit, 1.0);
    EXPECT_EQ(campus.scenes[1].scale, 1.0);
    EXPECT_EQ(campus.scenes[1].position, Eigen::Vector3d(0, 0, 0));
    EXPECT_THAT(campus.layers, ElementsAre("ground", "street-furniture"));

    ASSERT_EQ(campus.buildings.size(), 2U);
    const scene::Building& library = campus.buildings[0];
    EXPECT_EQ(library.id, "main-library");
    ASSERT_EQ(library.nodes.size(), 2U);
    EXPECT_EQ(library.nodes[1].pattern, "library_*");
    EXPECT_EQ(library.nodes[1].mark.line, 8);
    EXPECT_EQ(library.nodes[1].mark.column, 24);
    EXPECT_EQ(library.title, "Main Library");
    EXPECT_EQ(library.kind, "library");
    EXPECT_EQ(library.text, "Four floors.\nQuiet.");
    EXPECT_EQ(library.hours, "08-22");
    EXPECT_EQ(library.floors, 4);
    ASSERT_EQ(campus.buildings[1].nodes.size(), 1U);
    EXPECT_EQ(campus.buildings[1].nodes[0].pattern, "hut");

    ASSERT_EQ(campus.spawns.size(), 2U);
    EXPECT_EQ(campus.spawns[0].name, "gate");
    EXPECT_EQ(campus.spawns[0].position, Eigen::Vector3d(0, 1.5, 24));
    EXPECT_NEAR(campus.spawns[0].yaw, -std::numbers::pi / 2, 1e-15);
    EXPECT_EQ(campus.spawns[1].yaw, 0.0);
    ASSERT_EQ(campus.places.size(), 1U);
    EXPECT_EQ(campus.places[0].name, "door");
    EXPECT_EQ(campus.places[0].position, Eigen::Vector3d(4, 5, -6));
}

TEST_F(ReadCampus, ReadsUnits) {
    for (const auto& [unit, metres] : std::vector<std::pair<std::string, double>>{
             {"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"ft", 0.3048}}) {
        const CampusDescription campus = read("scenes: [{file: a.obj, unit: " + unit + "}]\ncolliders: []\n");
        EXPECT_EQ(campus.scenes.at(0).metres_per_unit, metres) << unit;
    }
}

TEST_F(ReadCampus, ReadsWhereScenesArePlaced) {
    const CampusDescription campus = read(R"(
scenes:
  - {file: a.glb, position: [1, 2, 3]}
  - {file: a.glb, position: [1, 2, 3], rotation_deg: [0, 90, 0]}
  - {file: a.glb, name: gate, quaternion: [0, 2, 0, 2]}
  - file: a.glb
    scale: 2
    placements:
      - {position: [4, 5, 6], rotation_deg: [10, 20, 30], scale: 0.5, name: first}
      - {}
colliders: []
)");
    ASSERT_EQ(campus.scenes.size(), 4U);
    EXPECT_TRUE(campus.scenes[0].placements.empty());
    EXPECT_EQ(campus.scenes[0].position, Eigen::Vector3d(1, 2, 3));

    Eigen::Matrix3d left;  // +X turns to -Z
    left << 0, 0, 1, 0, 1, 0, -1, 0, 0;
    ASSERT_EQ(campus.scenes[1].placements.size(), 1U);
    EXPECT_EQ(campus.scenes[1].position, Eigen::Vector3d(0, 0, 0));
    EXPECT_EQ(campus.scenes[1].placements[0].position, Eigen::Vector3d(1, 2, 3));
    EXPECT_LT((campus.scenes[1].placements[0].rotation - left).norm(), 1e-15);
    ASSERT_EQ(campus.scenes[2].placements.size(), 1U);
    EXPECT_EQ(campus.scenes[2].placements[0].name, "gate");
    EXPECT_LT((campus.scenes[2].placements[0].rotation - left).norm(), 1e-14);

    ASSERT_EQ(campus.scenes[3].placements.size(), 2U);
    const scene::ScenePlacement& first = campus.scenes[3].placements[0];
    EXPECT_EQ(campus.scenes[3].scale, 2.0);
    EXPECT_EQ(first.scale, 0.5);
    EXPECT_EQ(first.name, "first");
    EXPECT_EQ(first.position, Eigen::Vector3d(4, 5, 6));
    EXPECT_EQ(first.mark.line, 9);
    EXPECT_EQ(campus.scenes[3].placements[1].rotation, Eigen::Matrix3d::Identity());
}

TEST_F(ReadCampus, RefusesPlacementsThatContradictThemselves) {
    const auto about_scene = [this](const std::string& keys) {
        return folder_.about_campus("scenes: [{file: a.glb, " + keys + "}]\ncolliders: []\n");
    };
    EXPECT_THAT(about_scene("rotation_deg: [0, 90]"),
                ElementsAre(testing::HasSubstr("wrong-type: 'rotation_deg' must be three numbers")));
    EXPECT_THAT(about_scene("quaternion: [0, 1, 0]"),
                ElementsAre(testing::HasSubstr("wrong-type: 'quaternion' must be four numbers")));
    EXPECT_THAT(about_scene("quaternion: [0, 0, 0, 0]"),
                ElementsAre(testing::HasSubstr("bad-value: 'quaternion' has no direction")));
    EXPECT_THAT(about_scene("quaternion: [0, 0, 0, 1e-300]"),
                ElementsAre(testing::HasSubstr("'quaternion' has no direction")));
    EXPECT_THAT(about_scene("rotation_deg: [0, 9, 0], quaternion: [0, 0, 0, 1]"),
                ElementsAre(testing::HasSubstr("write one of them")));
    EXPECT_THAT(about_scene("placements: []"),
                ElementsAre(testing::HasSubstr("'placements' needs at least one entry")));
    EXPECT_THAT(about_scene("placements: [{}], position: [1, 2, 3]"),
                ElementsAre(testing::HasSubstr("'position' stands beside 'placements'")));
    EXPECT_THAT(about_scene("placements: [{scale: 0}]"), ElementsAre(testing::HasSubstr("bad-value")));
    EXPECT_THAT(about_scene("placements: [{file: b.glb}]"), ElementsAre(testing::HasSubstr("unknown-key")));
}

TEST_F(ReadCampus, AcceptsEmptySectionsAliasesAndQuotedKeys) {
    EXPECT_THAT(about("layers:\nbuildings:\nspawns:\nplaces: {}\n"), ElementsAre());
    EXPECT_THAT(about("spawns: {a: &a {at: [0, 0, 0]}, b: *a}\n"), ElementsAre());
    EXPECT_THAT(about("\"layers\": ['ground', \"trees\"]\n"), ElementsAre());
}

TEST_F(ReadCampus, DiagnosesMissingAndUnknownTopLevelKeys) {
    EXPECT_THAT(folder_.about_campus("[]\n"), ElementsAre(says("a.campus.yaml:1:1: error wrong-type")));
    EXPECT_THAT(folder_.about_campus("{}\n"),
                ElementsAre(says("a.campus.yaml:1:1: error missing-key"),
                            says("a.campus.yaml:1:1: error missing-key", {"'colliders'"})));
    EXPECT_THAT(folder_.about_campus("scene: []\ncolliders: []\n"),
                ElementsAre(says("a.campus.yaml:1:1: error missing-key"),
                            says("a.campus.yaml:1:1: error unknown-key", {"'scene'", "'scenes'"})));
    EXPECT_THAT(about("weather: rain\n"),
                ElementsAre(says("a.campus.yaml:3:1: error unknown-key", {"'weather'"})));
}

TEST_F(ReadCampus, DiagnosesScenes) {
    const auto about_scenes = [&](const std::string& scenes) {
        return folder_.about_campus("colliders: []\nscenes: " + scenes + "\n");
    };
    EXPECT_THAT(about_scenes("[]"), ElementsAre(says("a.campus.yaml:2:9: error bad-value", {"'scenes'"})));
    EXPECT_THAT(about_scenes(""), ElementsAre(says("a.campus.yaml:2:1: error bad-value", {"'scenes'"})));
    EXPECT_THAT(about_scenes("a.obj"),
                ElementsAre(says("a.campus.yaml:2:9: error wrong-type", {"'scenes'"})));
    EXPECT_THAT(about_scenes("[a.obj]"), ElementsAre(says("a.campus.yaml:2:10: error wrong-type")));
    EXPECT_THAT(about_scenes("[{fil: a.obj}]"),
                ElementsAre(says("a.campus.yaml:2:10: error missing-key", {"'file'"}),
                            says("a.campus.yaml:2:11: error unknown-key", {"'fil'", "'file'"})));
    EXPECT_THAT(about_scenes("[{file: }, {file: ''}, {file: [a]}]"),
                ElementsAre(says("a.campus.yaml:2:17: error wrong-type", {"'file'"}),
                            says("a.campus.yaml:2:27: error bad-value", {"'file'"}),
                            says("a.campus.yaml:2:39: error wrong-type", {"'file'"})));
    EXPECT_THAT(about_scenes("[{file: a, up: Z, unit: inch, scale: 0, position: [1, 2]}]"),
                ElementsAre(says("a.campus.yaml:2:24: error bad-value", {"'up'", "'Z'"}),
                            says("a.campus.yaml:2:33: error bad-value", {"'unit'", "'inch'"}),
                            says("a.campus.yaml:2:46: error bad-value", {"'scale'", "'0'"}),
                            says("a.campus.yaml:2:59: error wrong-type", {"'position'"})));
}

TEST_F(ReadCampus, ReadsTheOrigin) {
    const auto origin_of = [&](const std::string& origin) {
        return read("scenes: [{file: a.obj}]\ncolliders: []\norigin: " + origin + "\n").origin;
    };
    EXPECT_FALSE(origin_of("{}").origin.is_known());
    EXPECT_TRUE(origin_of("{at: near}").near);
    EXPECT_EQ(origin_of("{at: [84000, 0, -447000.5]}").origin.at, Eigen::Vector3d(84000, 0, -447000.5));
    const auto place =
        origin_of("{latitude_deg: -33.5, longitude_deg: 151.25, height: 12}").origin.geographic;
    EXPECT_EQ(place, (scene::GeographicPlace{-33.5, 151.25, 12, {0, 0, 0}}));
}

TEST_F(ReadCampus, DiagnosesTheOrigin) {
    EXPECT_THAT(about("origin: {at: here, latitude_deg: 91, longitude_deg: -180.5, altitude: 3}\n"),
                ElementsAre(says("a.campus.yaml:3:14: error bad-value", {"'at'"}),
                            says("a.campus.yaml:3:34: error bad-value", {"'latitude_deg'", "'91'"}),
                            says("a.campus.yaml:3:53: error bad-value", {"'longitude_deg'", "'-180.5'"}),
                            says("a.campus.yaml:3:61: error unknown-key", {"'altitude'", "'origin'"})));
    EXPECT_THAT(about("origin: {latitude_deg: 52}\n"),
                ElementsAre(says("a.campus.yaml:3:9: error missing-key", {"'origin'", "'longitude_deg'"})));
}

TEST_F(ReadCampus, DiagnosesNumbers) {
    EXPECT_THAT(about("places: {a: [010, 0x10, 1_000], b: [.inf, -.nan, 1e999], c: ['1', 1e8, x]}\n"),
                ElementsAre(says("a.campus.yaml:3:14: error bad-value", {"'a'", "'010'"}),
                            says("a.campus.yaml:3:19: error wrong-type", {"'a'", "'0x10'"}),
                            says("a.campus.yaml:3:25: error wrong-type", {"'a'", "'1_000'"}),
                            says("a.campus.yaml:3:37: error bad-value", {"'b'", "'.inf'"}),
                            says("a.campus.yaml:3:43: error bad-value", {"'b'", "'-.nan'"}),
                            says("a.campus.yaml:3:50: error bad-value", {"'b'", "'1e999'"}),
                            says("a.campus.yaml:3:62: error wrong-type", {"'c'", "'1'"}),
                            says("a.campus.yaml:3:67: error bad-value", {"'c'", "'1e8'"}),
                            says("a.campus.yaml:3:72: error wrong-type", {"'c'", "'x'"})));
}

TEST_F(ReadCampus, DiagnosesLayers) {
    EXPECT_THAT(about("layers: [Groun., a b, trees, trees, '', [x]]\n"),
                ElementsAre(says("a.campus.yaml:3:10: error bad-value", {"'Groun.'"}),
                            says("a.campus.yaml:3:18: error bad-value"),
                            says("a.campus.yaml:3:30: error duplicate-name", {"'trees'"}),
                            says("a.campus.yaml:3:37: error bad-value"),
                            says("a.campus.yaml:3:41: error wrong-type")));
    EXPECT_THAT(about("layers: ground\n"),
                ElementsAre(says("a.campus.yaml:3:9: error wrong-type", {"'layers'"})));
}

TEST_F(ReadCampus, DiagnosesBuildings) {
    EXPECT_THAT(
        about("buildings:\n"
              "  - {id: hut}\n"
              "  - {id: hut, title: a, floors: 1.5}\n"
              "  - {title: b, floors: many}\n"
              "  - hut\n"
              "  -\n"
              "  - {id: _, title: [x], floors: -1, hours: [8], text: {a: b}, kind: ~}\n"
              "  - {id: c, title: \"two\\nlines\", text: \"a\\u0007b\", nodes: 3}\n"),
        ElementsAre(says("a.campus.yaml:4:5: error missing-key", {"'title'"}),
                    says("a.campus.yaml:5:10: error duplicate-name", {"'hut'"}),
                    says("a.campus.yaml:5:33: error bad-value", {"'floors'", "'1.5'"}),
                    says("a.campus.yaml:6:5: error missing-key", {"'id'"}),
                    says("a.campus.yaml:6:24: error wrong-type", {"'floors'", "'many'"}),
                    says("a.campus.yaml:7:5: error wrong-type"), says("a.campus.yaml:8:3: error wrong-type"),
                    says("a.campus.yaml:9:10: error bad-value", {"'id'", "'_'"}),
                    says("a.campus.yaml:9:20: error wrong-type", {"'title'"}),
                    says("a.campus.yaml:9:33: error bad-value", {"'floors'", "'-1'"}),
                    says("a.campus.yaml:9:44: error wrong-type", {"'hours'"}),
                    says("a.campus.yaml:9:55: error wrong-type", {"'text'"}),
                    says("a.campus.yaml:9:69: error wrong-type", {"'kind'"}),
                    says("a.campus.yaml:10:20: error bad-value", {"'title'"}),
                    says("a.campus.yaml:10:40: error bad-value", {"'text'"})));
}

TEST_F(ReadCampus, DiagnosesSpawnsAndPlaces) {
    EXPECT_THAT(about("spawns: [a]\nplaces: a\n"),
                ElementsAre(says("a.campus.yaml:3:9: error wrong-type", {"'spawns'"}),
                            says("a.campus.yaml:4:9: error wrong-type", {"'places'"})));
    EXPECT_THAT(about("spawns: {a: [1, 2, 3], b: {at: [1, 2], yaw: 3}, _: {yaw_deg: 99999}}\n"),
                ElementsAre(says("a.campus.yaml:3:13: error wrong-type"),
                            says("a.campus.yaml:3:32: error wrong-type", {"'at'"}),
                            says("a.campus.yaml:3:40: error unknown-key", {"'yaw'"}),
                            says("a.campus.yaml:3:49: error bad-value", {"'_'"}),
                            says("a.campus.yaml:3:52: error missing-key", {"'at'"}),
                            says("a.campus.yaml:3:62: error bad-value", {"'yaw_deg'", "'99999'"})));
    EXPECT_THAT(about("places:\n  a:\n  b: {}\n  c: [1, 2]\n  a: [1, 2, 3]\n"),
                ElementsAre(says("a.campus.yaml:4:3: error wrong-type", {"'a'"}),
                            says("a.campus.yaml:5:6: error wrong-type", {"'b'"}),
                            says("a.campus.yaml:6:6: error wrong-type", {"'c'"}),
                            says("a.campus.yaml:7:3: error duplicate-key", {"'a'"})));
}

}  // namespace
}  // namespace campuswalk::config
