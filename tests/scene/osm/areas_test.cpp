#include "scene/osm/areas.h"

#include <gtest/gtest.h>

#include "tests/scene/osm/imported_map.h"

namespace campuswalk::scene::osm {
namespace {

using test::MapText;

const DraftBuilding* titled(const ImportedMap& imported, const std::string& title) {
    const auto found = std::ranges::find(imported.draft.buildings, title, &DraftBuilding::title);
    return found == imported.draft.buildings.end() ? nullptr : &*found;
}

TEST_F(ImportMap, TakesWhatARelationSaysOfItsBuilding) {
    MapText map;
    const auto outline = map.rectangle(-20, -10, 20, 10, {{"building", "yes"}, {"height", "6"}});
    const auto part = map.rectangle(-20, -10, 0, 10, {{"building:part", "yes"}, {"height", "12"}});
    map.relation({{outline, "outline"}, {part, "part"}},
                 {{"type", "building"}, {"name", "Main Hall"}, {"height", "99"}, {"opening_hours", "24/7"}});
    const ImportedMap imported = import(map.xml());
    const DraftBuilding* hall = titled(imported, "Main Hall");
    ASSERT_NE(hall, nullptr);
    EXPECT_EQ(hall->id, "building-" + std::to_string(outline));
    EXPECT_EQ(hall->hours, "24/7");
    const std::string node = "building/way-" + std::to_string(outline);
    EXPECT_NEAR(bounds_of(imported.model, node).max.y(), 6.0, 0.01) << "the outline's own height counts";
    EXPECT_NEAR(bounds_of(imported.model, node + "/way-" + std::to_string(part)).max.y(), 12.0, 0.01);
}

TEST_F(ImportMap, GivesNamedPartsAPopUp) {
    MapText map;
    map.rectangle(-20, -10, 20, 10, {{"building", "yes"}, {"height", "6"}, {"name", "Museum"}});
    const auto wing =
        map.rectangle(-20, -10, 0, 10, {{"building:part", "yes"}, {"height", "12"}, {"name", "West Wing"}});
    map.rectangle(0, -10, 20, 10, {{"building:part", "yes"}, {"height", "8"}, {"name", "Museum"}});
    const ImportedMap imported = import(map.xml());
    EXPECT_EQ(imported.draft.buildings.size(), 2U) << "a part called like the whole isn't another";
    const DraftBuilding* part = titled(imported, "West Wing");
    ASSERT_NE(part, nullptr);
    EXPECT_EQ(part->id, "part-" + std::to_string(wing));
    const auto trigger = std::ranges::find(imported.draft.triggers, part->id, &DraftTrigger::building);
    ASSERT_NE(trigger, imported.draft.triggers.end());
    EXPECT_NEAR(trigger->center.x(), -10.0, 0.01);
    EXPECT_NEAR(trigger->size.x() * trigger->size.z(), 23.0 * 23.0, 0.5);
}

}  // namespace
}  // namespace campuswalk::scene::osm
