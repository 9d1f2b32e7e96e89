#include "scene/osm/objects/steps.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/scene/osm/imported_map.h"

namespace campuswalk::scene::osm {
namespace {

using test::MapText;

class Steps : public ImportMap {
protected:
    /// A flight of 6 m that runs north from 0, 0 as drawn.
    MapText flight(const MapText::Tags& tags, bool drawn_south = false) {
        MapText map;
        MapText::Tags all = {{"highway", "steps"}, {"width", "2"}};
        all.insert(all.end(), tags.begin(), tags.end());
        id_ = drawn_south ? map.way({{0, 6}, {0, 0}}, all) : map.way({{0, 0}, {0, 6}}, all);
        map.way({{0, -60}, {0, 0}}, {{"highway", "footway"}});
        return map;
    }
    std::string steps() const { return "steps/way-" + std::to_string(id_); }
    std::string ramp() const { return "ramp/way-" + std::to_string(id_); }

    std::int64_t id_ = 0;
};

/// Of the highest level face that is wider than a handrail.
double top_tread(const Model& model, const std::string& name) {
    double top = -1e9;
    for_triangles(model, *find(model, name), [&](const auto& a, const auto& b, const auto& c) {
        if (a.y() == b.y() && b.y() == c.y() && (b - a).cross(c - a).y() > 0.2) {
            top = std::max(top, a.y());
        }
    });
    return top;
}

TEST_F(Steps, RiseAsTagged) {
    MapText counted = flight({{"step_count", "15"}});
    EXPECT_NEAR(top_tread(import(counted.xml()).model, steps()), 15 * 0.16, 0.01);
    MapText percent = flight({{"incline", "50%"}});
    EXPECT_NEAR(top_tread(import(percent.xml()).model, steps()), 3.0, 0.01);
    MapText degrees = flight({{"incline", "-20\u00b0"}}, true);
    const Model model = import(degrees.xml()).model;
    EXPECT_NEAR(top_tread(model, steps()), 6.0 * 0.36397, 0.01) << "the tangent of 20 degrees";
    EXPECT_NEAR(top_at(model, 0.1, 0.1, steps()), top_tread(model, steps()) / 14.0, 0.02)
        << "drawn southwards and down, its foot is in the south";
}

TEST_F(Steps, RiseByTheirInclineAlsoWithACount) {
    MapText both = flight({{"incline", "40%"}, {"step_count", "20"}});
    const ImportedMap imported = import(both.xml());
    EXPECT_NEAR(top_tread(imported.model, steps()), 2.4, 0.01);
    EXPECT_FALSE(test::has_code(imported.warnings, "odd-steps"));
    MapText few = flight({{"incline", "50%"}, {"step_count", "12"}});
    const ImportedMap changed = import(few.xml());
    EXPECT_NEAR(top_tread(changed.model, steps()), 3.0, 0.01);
    EXPECT_TRUE(test::has_code(changed.warnings, "odd-steps")) << "risers of 25 cm";
    MapText ratio = flight({{"incline", "1:3"}});
    EXPECT_TRUE(test::has_code(import(ratio.xml()).warnings, "odd-steps"));
    for (const char* fine : {"up", "down", "30 %", "-17\u00b0"}) {
        MapText map = flight({{"incline", fine}});
        EXPECT_FALSE(test::has_code(import(map.xml()).warnings, "odd-steps")) << fine;
    }
}

TEST_F(Steps, LeadUpToAnEntranceThatTheyBeginAt) {
    // Of a building in the north.
    const auto rise_to_entrance = [&](bool drawn_from_entrance, const MapText::Tags& tags) {
        MapText map;
        const auto entrance = map.node(0, 10, {{"entrance", "yes"}});
        const auto end = map.node(0, 7);
        const auto west = map.node(-8, 10);
        map.way_of({west, entrance, map.node(8, 10), map.node(8, 20), map.node(-8, 20), west},
                   {{"building", "yes"}, {"name", "Hall"}});
        MapText::Tags all = {{"highway", "steps"}, {"width", "3"}, {"step_count", "8"}};
        all.insert(all.end(), tags.begin(), tags.end());
        id_ = map.way_of(drawn_from_entrance ? std::vector{entrance, end} : std::vector{end, entrance}, all);
        map.way({{0, -60}, {0, 7}}, {{"highway", "footway"}});
        const ImportedMap imported = import(map.xml());
        const auto place = std::ranges::find(imported.draft.places, "entrance-" + std::to_string(entrance),
                                             &DraftPlace::name);
        EXPECT_NE(place, imported.draft.places.end());
        if (place != imported.draft.places.end()) {
            EXPECT_NEAR(place->at.y(), top_at(imported.model, place->at.x(), -place->at.z(), steps()), 0.2);
        }
        return top_at(imported.model, 0, 9.9, steps()) - top_at(imported.model, 0, 7.1, steps());
    };
    EXPECT_GT(rise_to_entrance(true, {}), 0.7);
    EXPECT_GT(rise_to_entrance(false, {}), 0.7);
    EXPECT_LT(rise_to_entrance(true, {{"incline", "up"}}), -0.7) << "down to a basement";
}

TEST_F(Steps, HaveHandrailsOnTheSideOfTheirDirectionAsDrawn) {
    const auto middle_of_rail = [&](const Model& model) {
        double sum = 0.0;
        int count = 0;
        for_triangles(model, *find(model, steps()), [&](const auto& a, const auto&, const auto&) {
            if (a.y() > top_tread(model, steps()) + 0.3) {
                sum += a.x();
                ++count;
            }
        });
        return count == 0 ? std::nan("") : sum / count;
    };
    MapText left_up = flight({{"incline", "up"}, {"handrail:left", "yes"}});
    EXPECT_NEAR(middle_of_rail(import(left_up.xml()).model), -0.94, 0.03);
    MapText left_down = flight({{"incline", "down"}, {"handrail:left", "yes"}}, true);
    EXPECT_NEAR(middle_of_rail(import(left_down.xml()).model), 0.94, 0.03);
    MapText right = flight({{"incline", "up"}, {"handrail:right", "yes"}});
    EXPECT_NEAR(middle_of_rail(import(right.xml()).model), 0.94, 0.03);
    MapText center = flight({{"incline", "up"}, {"handrail:center", "yes"}});
    EXPECT_NEAR(middle_of_rail(import(center.xml()).model), 0.0, 0.03);
}

TEST_F(Steps, HaveRampsForWheelchairsOfOneInTwelve) {
    MapText map = flight({{"step_count", "8"}, {"ramp:wheelchair", "yes"}});
    const ImportedMap imported = import(map.xml());
    const Model& model = imported.model;
    ASSERT_NE(find(model, ramp()), nullptr);
    EXPECT_FALSE(test::has_code(imported.warnings, "steep-ramp"));
    const double rise = 8 * 0.16;
    EXPECT_NEAR(top_at(model, 1.6, 5.9, ramp()), rise, 0.05) << "beside its right edge, as high";
    EXPECT_NEAR(bounds_of(model, ramp()).max.x() - bounds_of(model, ramp()).min.x(), 1.2, 0.02);
    const double length = bounds_of(model, ramp()).max.z() - bounds_of(model, ramp()).min.z();
    EXPECT_NEAR(length, 12.0 * rise, 1.0);
    for (int i = 1; 6.0 - length + i < -1.0; ++i) {
        const double north = 6.0 - length + i;
        const double slope =
            top_at(model, 1.6, north + 0.5, ramp()) - top_at(model, 1.6, north - 0.5, ramp());
        EXPECT_NEAR(slope, rise / length, 0.03) << north;
    }
}

TEST_F(Steps, HaveSteeperRampsForStrollersAndNoneWhereTheyAreSeparate) {
    MapText map = flight({{"step_count", "15"}, {"ramp:stroller", "yes"}});
    const Model model = import(map.xml()).model;
    EXPECT_NEAR(bounds_of(model, ramp()).max.z() - bounds_of(model, ramp()).min.z(), 6.0, 0.05);
    EXPECT_NEAR(top_at(model, 1.45, 3.0, ramp()), 7.5 * 0.16, 0.2);
    for (const char* none : {"no", "separate"}) {
        MapText without = flight({{"step_count", "15"}, {"ramp", none}});
        EXPECT_EQ(find(import(without.xml()).model, ramp()), nullptr) << none;
    }
}

TEST_F(Steps, WarnWhereThereIsNoRoomForARamp) {
    MapText map = flight({{"step_count", "15"}, {"ramp:wheelchair", "yes"}});
    map.rectangle(0.5, -20, 10, -2, {{"building", "yes"}});
    EXPECT_TRUE(test::has_code(import(map.xml()).warnings, "steep-ramp"));
}

TEST_F(Steps, GoOnBeyondTheEdgeOfTheMap) {
    MapText map;
    const auto id = map.way({{0, -105}, {0, -90}}, {{"highway", "steps"}});
    map.way({{0, -90}, {0, 0}}, {{"highway", "footway"}});
    map.rectangle(-20, -140, -10, -80, {{"building", "yes"}});  // for which the ground reaches further
    const Model model = import(map.xml()).model;
    EXPECT_FALSE(heights_at(model, 0.1, -95.0).empty()) << "no pit";
    EXPECT_NE(find(model, "steps/way-" + std::to_string(id)), nullptr);
}

}  // namespace
}  // namespace campuswalk::scene::osm
