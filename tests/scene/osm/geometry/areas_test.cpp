#include "scene/osm/geometry/areas.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

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

/// A building of 40 m by 40 m with courts, whose roof has what area?
class Courts : public ImportMap {
protected:
    using Ring = MapText::Points;

    double roof_area(const std::vector<Ring>& inner, const Ring& outer = kSquare) {
        MapText map;
        std::map<std::pair<double, double>, std::int64_t> nodes;  // rings that touch share them
        const auto way_of = [&](const Ring& ring) {
            std::vector<std::int64_t> refs;
            for (const auto& at : ring) {
                const auto [known, is_new] = nodes.try_emplace(at, 0);
                known->second = is_new ? map.node(at.first, at.second) : known->second;
                refs.push_back(known->second);
            }
            refs.push_back(refs.front());
            return map.way_of(refs);
        };
        std::vector<std::pair<std::int64_t, std::string>> members = {{way_of(outer), "outer"}};
        for (const Ring& ring : inner) {
            members.emplace_back(way_of(ring), "inner");
        }
        const auto id = map.relation(members, {{"type", "multipolygon"}, {"building", "yes"}});
        const Model model = import(map.xml()).model;
        return plan_area(model, *find(model, "building/relation-" + std::to_string(id)));
    }
    static Ring box(double west, double south, double east, double north) {
        return {{west, south}, {east, south}, {east, north}, {west, north}};
    }

    inline static const Ring kSquare = {{0, 0}, {40, 0}, {40, 40}, {0, 40}};
};

TEST_F(Courts, ThatTouchAlongAnEdgeAreOne) {
    EXPECT_NEAR(roof_area({box(10, 10, 20, 30), box(20, 10, 30, 30)}), 1200, 1) << "a whole edge";
    EXPECT_NEAR(roof_area({box(5, 10, 15, 30), box(15, 10, 25, 30), box(25, 10, 35, 30)}), 1000, 1);
    EXPECT_NEAR(
        roof_area({{{10, 10}, {20, 10}, {20, 15}, {20, 25}, {20, 30}, {10, 30}}, box(20, 15, 30, 25)}), 1300,
        1)
        << "a part of one";
    EXPECT_NEAR(roof_area({box(10, 10, 20, 30), box(20, 15, 30, 25)}), 1300, 1) << "without common nodes";
}

TEST_F(Courts, ThatTouchTheOuterRingAreOpenToOutside) {
    const Ring outer = {{0, 0}, {40, 0}, {40, 40}, {0, 40}, {0, 30}, {0, 10}};
    EXPECT_NEAR(roof_area({box(0, 10, 10, 30)}, outer), 1400, 1);
}

TEST_F(Courts, ThatTouchButForACentimetreAreOne) {
    EXPECT_NEAR(roof_area({box(10, 10, 20, 30), box(20.01, 15, 30, 25)}), 1300, 1);
    EXPECT_NEAR(roof_area({box(10, 10, 20, 30), {{20.01, 15}, {30, 15}, {30, 25}, {20, 25}}}), 1300, 1);
    EXPECT_NEAR(roof_area({box(10, 10, 20, 30), box(19.99, 15, 30, 25)}), 1300, 1) << "an overlap";
    EXPECT_NEAR(roof_area({box(0.01, 10, 10, 30)}), 1400, 1) << "open to outside";
    EXPECT_NEAR(roof_area({box(10, 10, 20, 30), box(20.2, 10, 30, 30)}), 1204, 1) << "a wall of 20 cm";
}

TEST_F(Courts, ThatTouchInAPointOrNotAtAllStaySeparate) {
    EXPECT_NEAR(roof_area({box(10, 10, 20, 20), box(20, 20, 30, 30)}), 1400, 1);
    EXPECT_NEAR(roof_area({box(10, 10, 19, 30), box(21, 10, 30, 30)}), 1240, 1);
}

TEST_F(ImportMap, BuildsIslandsInCourtsAndOuterRingsThatTouch) {
    MapText map;
    const auto outer = map.rectangle(0, 0, 40, 40);
    const auto inner = map.rectangle(10, 10, 30, 30);
    const auto island = map.rectangle(15, 15, 25, 25);
    const auto beside = map.rectangle(40, 0, 60, 40);
    const auto id = map.relation({{outer, "outer"}, {inner, "inner"}, {island, "outer"}, {beside, "outer"}},
                                 {{"type", "multipolygon"}, {"building", "yes"}});
    const Model model = import(map.xml()).model;
    EXPECT_NEAR(plan_area(model, *find(model, "building/relation-" + std::to_string(id))),
                1600.0 - 400.0 + 100.0 + 800.0, 2.0);
}

TEST_F(ImportMap, TakesTheMiddleOfCourtsWhoseRingsAreCutIntoWays) {
    MapText map;
    const auto outer = map.rectangle(0, 0, 40, 40);
    const auto a = map.node(20, 10);
    const auto b = map.node(20, 30);
    const auto west = map.way_of({a, map.node(10, 10), map.node(10, 30), b});
    const auto east = map.way_of({b, map.node(30, 30), map.node(30, 10), a});
    const auto between = map.way_of({a, b});
    const auto id = map.relation({{outer, "outer"}, {west, "inner"}, {east, "inner"}, {between, "inner"}},
                                 {{"type", "multipolygon"}, {"building", "yes"}});
    const Model model = import(map.xml()).model;
    EXPECT_NEAR(plan_area(model, *find(model, "building/relation-" + std::to_string(id))), 1200.0, 1.0);
}

/// A block of 40 m by 40 m with a court of 20 m by 20 m and a wing of 20 m by 40 m, some of whose ways the
/// file lacks.
class CutRelations : public ImportMap {
protected:
    struct Result {
        double area = 0.0;
        std::size_t reported = 0;
    };

    Result result_without(const std::string& missing) {
        MapText map;
        map.way({{-90, -90}, {90, -90}}, {{"highway", "footway"}});
        constexpr std::int64_t kMissing = 987654;
        const auto there = [&](const std::string& name, std::int64_t id) {
            return name == missing ? kMissing : id;
        };
        const auto id = map.relation({{there("outer", map.rectangle(0, 0, 40, 40)), "outer"},
                                      {there("inner", map.rectangle(10, 10, 30, 30)), "inner"},
                                      {there("wing", map.rectangle(50, 0, 70, 40)), "outer"}},
                                     {{"type", "multipolygon"}, {"building", "yes"}, {"height", "9"}});
        const ImportedMap imported = import(map.xml());
        const Node* node = find(imported.model, "building/relation-" + std::to_string(id));
        Result result;
        result.area = node == nullptr ? 0.0 : plan_area(imported.model, *node);
        for (const Diagnostic& warning : imported.warnings) {
            const bool named = warning.message.find(std::to_string(id)) != std::string::npos;
            result.reported += named && warning.code == "incomplete-relation" ? 1U : 0U;
        }
        return result;
    }
};

TEST_F(CutRelations, AreBuiltOfTheOuterRingsThatAreThereAndReported) {
    EXPECT_NEAR(result_without("nothing").area, 2000.0, 2.0);
    EXPECT_EQ(result_without("nothing").reported, 0U);
    EXPECT_NEAR(result_without("wing").area, 1200.0, 2.0);
    EXPECT_EQ(result_without("wing").reported, 1U);
    EXPECT_NEAR(result_without("inner").area, 2400.0, 2.0);
    EXPECT_EQ(result_without("inner").reported, 1U);
    EXPECT_NEAR(result_without("outer").area, 800.0, 2.0) << "nothing stands in the court";
    EXPECT_EQ(result_without("outer").reported, 1U);
}

TEST_F(CutRelations, OfInnerRingsAloneAreLeftOut) {
    MapText map;
    map.way({{-90, -90}, {90, -90}}, {{"highway", "footway"}});
    for (const char* key : {"building", "natural"}) {
        const auto inner = map.rectangle(10, 10, 30, 30);
        map.relation({{987654, "outer"}, {inner, "inner"}},
                     {{"type", "multipolygon"}, {key, std::string(key) == "natural" ? "water" : "yes"}});
    }
    const ImportedMap imported = import(map.xml());
    EXPECT_EQ(std::ranges::count(imported.warnings, DiagnosticCode("open-ring"), &Diagnostic::code), 2);
    for (const Node& node : imported.model.nodes) {
        EXPECT_FALSE(node.name.starts_with("building/") || node.name.starts_with("water")) << node.name;
    }
}

}  // namespace
}  // namespace campuswalk::scene::osm
