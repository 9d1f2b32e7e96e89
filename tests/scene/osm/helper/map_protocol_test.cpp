#include "scene/osm/helper/map_protocol.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace campuswalk::scene::osm {
namespace {

MapFiles good_files() {
    MapFiles files;
    files.glb = std::string("glTF\0\1", 6);
    files.triangles = 12;
    files.warnings = {{Severity::warning, {"a.osm", 3, 4}, "roof-shape", "way-1: its roof is flat"}};
    CampusDraft& draft = files.draft;
    draft.latitude_deg = 48.5;
    draft.longitude_deg = -11.25;
    draft.layers = {"building", "door"};
    draft.buildings = {{"building-1", "도서관 \"x\" {y}", "library", "Mo-Fr", 4, {{"name-en", "Library"}}}};
    draft.solids = {
        {"building-1/walls", {"building/way-1", "building/way-1/*"}, "building-1", "building", true}};
    draft.triggers = {{"building-1/entrance-5", "building-1", {1, 2, 3}, {2, 2, 2}, 45.5, "door"}};
    draft.spawns = {{"start", {4, 5, 6}, -90.0}};
    draft.places = {{"entrance-5", {7, 8, 9}, "building-1/entrance-5", 6}};
    return files;
}

MapFiles back(const MapFiles& files) {
    ArchiveWriter archive = archive_files(files);
    return read_map_response(concatenated(archive.finish()));
}

TEST(MapProtocol, BringsBackWhatWasSent) {
    const MapFiles sent = good_files();
    const MapFiles files = back(sent);
    EXPECT_EQ(files.glb, sent.glb);
    EXPECT_EQ(files.triangles, 12U);
    ASSERT_EQ(files.warnings.size(), 1U);
    EXPECT_EQ(to_string(files.warnings[0]), to_string(sent.warnings[0]));
    const CampusDraft& draft = files.draft;
    EXPECT_EQ(draft.latitude_deg, 48.5);
    EXPECT_EQ(draft.longitude_deg, -11.25);
    EXPECT_EQ(draft.layers, sent.draft.layers);
    ASSERT_EQ(draft.buildings.size(), 1U);
    EXPECT_EQ(draft.buildings[0].id, "building-1");
    EXPECT_EQ(draft.buildings[0].title, sent.draft.buildings[0].title);
    EXPECT_EQ(draft.buildings[0].kind, "library");
    EXPECT_EQ(draft.buildings[0].hours, "Mo-Fr");
    EXPECT_EQ(draft.buildings[0].floors, 4);
    EXPECT_EQ(draft.buildings[0].info, sent.draft.buildings[0].info);
    ASSERT_EQ(draft.solids.size(), 1U);
    EXPECT_EQ(draft.solids[0].id, "building-1/walls");
    EXPECT_EQ(draft.solids[0].globs, sent.draft.solids[0].globs);
    EXPECT_EQ(draft.solids[0].building, "building-1");
    EXPECT_EQ(draft.solids[0].layer, "building");
    EXPECT_TRUE(draft.solids[0].each);
    ASSERT_EQ(draft.triggers.size(), 1U);
    EXPECT_EQ(draft.triggers[0].id, "building-1/entrance-5");
    EXPECT_EQ(draft.triggers[0].building, "building-1");
    EXPECT_EQ(draft.triggers[0].center, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(draft.triggers[0].size, Eigen::Vector3d(2, 2, 2));
    EXPECT_EQ(draft.triggers[0].yaw_deg, 45.5);
    EXPECT_EQ(draft.triggers[0].layer, "door");
    ASSERT_EQ(draft.spawns.size(), 1U);
    EXPECT_EQ(draft.spawns[0].name, "start");
    EXPECT_EQ(draft.spawns[0].at, Eigen::Vector3d(4, 5, 6));
    EXPECT_EQ(draft.spawns[0].yaw_deg, -90.0);
    ASSERT_EQ(draft.places.size(), 1U);
    EXPECT_EQ(draft.places[0].name, "entrance-5");
    EXPECT_EQ(draft.places[0].at, Eigen::Vector3d(7, 8, 9));
    EXPECT_EQ(draft.places[0].trigger, "building-1/entrance-5");
    EXPECT_EQ(draft.places[0].importance, 6);
}

TEST(MapProtocol, BringsTheRequestToTheHelper) {
    MapHelperRequest request;
    request.map.mark = {"given.osm", 0, 0};
    request.map.file = "/maps/link-target";
    request.map.heights_mark = {"N48E011.hgt", 0, 0};
    request.map.heights = "/heights/abc";
    request.map.section.center = {48.0, 11.0};
    request.map.section.radius = 250.0;
    request.limits.memory = 123;
    request.sandbox = SandboxMode::require;
    const MapHelperRequest read = read_map_request(write_request(request));
    EXPECT_EQ(read.map.mark.file, "given.osm");
    EXPECT_EQ(read.map.file, "/maps/link-target");
    EXPECT_EQ(read.map.heights_mark.file, "N48E011.hgt");
    EXPECT_EQ(read.map.heights, "/heights/abc");
    EXPECT_FALSE(read.map.section.box.has_value());
    EXPECT_EQ(read.map.section.center, std::pair(48.0, 11.0));
    EXPECT_EQ(read.map.section.radius, 250.0);
    EXPECT_EQ(read.limits.memory, 123U);
    EXPECT_EQ(read.sandbox, SandboxMode::require);
}

TEST(MapProtocol, PassesErrorsOn) {
    MapFiles files;
    files.warnings = {{Severity::error, {"a.osm", 7, 1}, "bad-map", "it isn't well-formed XML"}};
    try {
        back(files);
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_EQ(to_string(error.diagnostics().front()),
                  "a.osm:7:1: error bad-map: it isn't well-formed XML");
    }
}

/// A helper that a map has taken over may send anything.
TEST(MapProtocol, RefusesWhatNoMapMakes) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<std::function<void(MapFiles&)>> changes = {
        [](MapFiles& f) { f.draft.places[0].name = "x\nsteps: []"; },
        [](MapFiles& f) { f.draft.places[0].name = ""; },
        [](MapFiles& f) { f.draft.places[0].name = "a: b"; },
        [](MapFiles& f) { f.draft.places[0].trigger = "a\", evil"; },
        [](MapFiles& f) { f.draft.places[0].importance = 1 << 30; },
        [&](MapFiles& f) { f.draft.places[0].at.x() = nan; },
        [](MapFiles& f) { f.draft.places[0].at.x() = 1e9; },
        [](MapFiles& f) { f.draft.spawns[0].name = "start}"; },
        [&](MapFiles& f) { f.draft.spawns[0].yaw_deg = nan; },
        [](MapFiles& f) { f.draft.buildings[0].id = "b, c"; },
        [](MapFiles& f) { f.draft.buildings[0].id = std::string(201, 'a'); },
        [](MapFiles& f) { f.draft.buildings[0].title = "a\nb"; },
        [](MapFiles& f) { f.draft.buildings[0].title = "a\u202Eb"; },
        [](MapFiles& f) { f.draft.buildings[0].title = "a\xFF"; },
        [](MapFiles& f) { f.draft.buildings[0].title = std::string(2001, 'a'); },
        [](MapFiles& f) { f.draft.buildings[0].hours = "\x1B[2J"; },
        [](MapFiles& f) { f.draft.buildings[0].floors = -1; },
        [](MapFiles& f) { f.draft.buildings[0].info[0].first = "name: x"; },
        [](MapFiles& f) { f.draft.solids[0].globs[0] = "a\"b"; },
        [](MapFiles& f) { f.draft.solids[0].globs[0] = "*"; },
        [](MapFiles& f) { f.draft.solids[0].id = "/walls"; },
        [](MapFiles& f) { f.draft.solids[0].layer = "[x"; },
        [](MapFiles& f) { f.draft.triggers[0].size.y() = 0.0; },
        [](MapFiles& f) { f.draft.layers[0] = "x]"; },
        [](MapFiles& f) { f.draft.latitude_deg = 91.0; },
        [](MapFiles& f) { f.warnings[0].code = {}; },
        [](MapFiles& f) { f.warnings[0].message = "a\nb: error c: d"; }};
    for (std::size_t i = 0; i < changes.size(); ++i) {
        MapFiles files = good_files();
        changes[i](files);
        EXPECT_THROW(back(files), DamagedFile) << i;
    }
}

TEST(MapProtocol, RefusesEachPartOfAResponse) {
    const MapFiles files = good_files();
    ArchiveWriter archive = archive_files(files);
    const std::vector<std::byte> whole = concatenated(archive.finish());
    for (std::size_t length = 0; length < whole.size(); length += 7) {
        EXPECT_THROW(read_map_response(std::span(whole).first(length)), DamagedFile) << length;
    }
}

}  // namespace
}  // namespace campuswalk::scene::osm
