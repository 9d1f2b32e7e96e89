#include "tools/campuswalk/import/draft_text.h"

#include <gtest/gtest.h>

#include "config/loader/load_campus.h"
#include "tests/support/temporary_folder.h"

namespace campuswalk::tools {
namespace {

TEST(DraftText, IsReadAsItWasMeant) {
    scene::osm::CampusDraft draft;
    draft.latitude_deg = 48.123456789;
    draft.longitude_deg = -11.5;
    draft.layers = {"building", "door"};
    const std::string title = "\xEB\x8F\x84 \"x\": {y} - &a *b #c 'd' \\n";
    draft.buildings = {{"building-1", title, "library", "Mo-Fr 08:00-20:00", 4, {{"name-en", "a: {b}"}}}};
    draft.solids = {
        {"building-1/walls", {"building/way-1", "building/way-1/*"}, "building-1", "building", true}};
    draft.triggers = {{"building-1/around", "building-1", {1, 2, -3.25}, {2, 2, 2}, 45.5, "door"}};
    draft.spawns = {{"start", {4, 0, -0.001}, -90.0}};
    draft.places = {{"entrance-5", {7, 8.129, 9}, "building-1/around", 6}};
    const support::TemporaryFolder folder;
    folder.write("a.campus.yaml", draft_yaml(draft, "a`\n- evil: 1\n.osm"));
    const scene::CampusDescription campus = config::load_campus_description(folder.path() / "a.campus.yaml");
    ASSERT_TRUE(campus.origin.origin.geographic.has_value());
    EXPECT_EQ(campus.origin.origin.geographic->latitude_deg, 48.123456789);
    ASSERT_EQ(campus.buildings.size(), 1U);
    EXPECT_EQ(campus.buildings[0].title, "\xEB\x8F\x84 \"x\": {{y}} - &a *b #c 'd' \\n")
        << "pop-ups halve braces";
    EXPECT_EQ(campus.buildings[0].hours, "Mo-Fr 08:00-20:00");
    EXPECT_EQ(campus.buildings[0].floors, 4);
    EXPECT_EQ(campus.buildings[0].info.size(), 1U);
    ASSERT_EQ(campus.colliders.size(), 2U);
    EXPECT_EQ(campus.colliders[0].nodes.size(), 2U);
    EXPECT_TRUE(campus.colliders[0].each);
    EXPECT_EQ(campus.colliders[1].building, "building-1");
    ASSERT_EQ(campus.spawns.size(), 1U);
    EXPECT_EQ(campus.spawns[0].position, Eigen::Vector3d(4, 0, 0));
    ASSERT_EQ(campus.places.size(), 1U);
    EXPECT_EQ(campus.places[0].position, Eigen::Vector3d(7, 8.13, 9));
}

TEST(DraftText, NamesTheMapWithoutItsTricks) {
    const std::string text = attribution_text("a`b\nc\u0085d\u202e.osm");  // U+0085 ends a line of YAML 1.1
    EXPECT_NE(text.find("`a_b\\nc\\x85d\\u202e.osm`"), std::string::npos) << text;
}

}  // namespace
}  // namespace campuswalk::tools
