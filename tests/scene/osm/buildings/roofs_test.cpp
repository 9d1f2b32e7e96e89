#include "scene/osm/buildings/roofs.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/scene/osm/imported_map.h"

namespace campuswalk::scene::osm {
namespace {

using test::MapText;

/// Of a solid whose sections are the footprint made smaller: a stack of frusta, by Heron of Alexandria's
/// formula. `rings`: its size, of 1, and its height, of 1.
double stack_volume(const std::vector<std::pair<double, double>>& rings, double area, double height) {
    double volume = 0.0;
    for (std::size_t i = 1; i < rings.size(); ++i) {
        const auto& [r0, h0] = rings[i - 1];
        const auto& [r1, h1] = rings[i];
        volume += area * height * (h1 - h0) * (r0 * r0 + r0 * r1 + r1 * r1) / 3.0;
    }
    return volume;
}

/// A quarter of a circle in seven steps.
double dome_volume() {
    std::vector<std::pair<double, double>> rings;
    rings.reserve(8);
    for (int i = 0; i < 7; ++i) {
        rings.emplace_back(std::cos(i * std::numbers::pi / 14.0), std::sin(i * std::numbers::pi / 14.0));
    }
    rings.emplace_back(0.0, 1.0);
    return stack_volume(rings, 200.0, 3.0);
}

TEST_F(ImportMap, MakesTheRoofsOfSimple3dBuildings) {
    struct Expected {
        const char* shape;
        double volume;  ///< of 20 by 10 m, 9 m high, of which the roof is 3
    };
    // A barrel is half of a 24-gon in an ellipse of 5 by 3 m.
    const double round = 1200.0 + 20.0 * 6.0 * std::sin(std::numbers::pi / 12.0) * 15.0;
    // Each end of a gabled roof loses a pyramid of half its height: 5² · 3 · 1/24 m³.
    const double half_hipped = 1500.0 - 2.0 * 25.0 * 3.0 / 24.0;
    // The section d of the way to the ridge is (20 - 10 d) by (10 - 10 d) m; its slope changes at 0.3.
    const auto below = [](double d) { return 200.0 * d - 150.0 * d * d + 100.0 / 3.0 * d * d * d; };
    const double mansard = 1200.0 + 3.0 * (2.5 * below(0.3) + 0.25 / 0.7 * (below(1.0) - below(0.3)));
    for (const Expected& roof : {Expected{"flat", 1800},
                                 {"gabled", 1500},
                                 {"hipped", 1450},
                                 {"pyramidal", 1400},
                                 {"skillion", 1500},
                                 {"gambrel", 1575},
                                 {"round", round},
                                 {"half-hipped", half_hipped},
                                 {"mansard", mansard},
                                 {"dome", 1200.0 + dome_volume()}}) {
        MapText map;
        const auto id = map.rectangle(
            -10, -5, 10, 5,
            {{"building", "yes"}, {"height", "9"}, {"roof:height", "3"}, {"roof:shape", roof.shape}});
        const Model model = import(map.xml()).model;
        const std::string name = "building/way-" + std::to_string(id);
        EXPECT_NEAR(volume_of(model, name), roof.volume, 0.001 * roof.volume) << roof.shape;
        EXPECT_NEAR(bounds_of(model, name).max.y(), 9.0, 0.01) << roof.shape;
        EXPECT_NEAR(plan_area(model, *find(model, name)), 200.0, 0.2) << roof.shape;
    }
}

TEST_F(ImportMap, ReadsTheAngleOfARoof) {
    for (const char* angle : {"30", "30\u00B0", "30 \u00B0"}) {
        MapText map;
        const auto id = map.rectangle(
            -10, -5, 10, 5,
            {{"building", "yes"}, {"building:levels", "2"}, {"roof:shape", "gabled"}, {"roof:angle", angle}});
        EXPECT_NEAR(bounds_of(import(map.xml()).model, "building/way-" + std::to_string(id)).max.y(),
                    6.0 + 5.0 * std::tan(std::numbers::pi / 6.0), 0.02)
            << angle;
    }
}

/// In the plan, of what faces down at a height.
double underside_at(const Model& model, const std::string& name, double height) {
    double area = 0.0;
    for_triangles(model, *find(model, name), [&](const auto& a, const auto& b, const auto& c) {
        const double down = -0.5 * (b - a).cross(c - a).y();
        const bool there = std::abs(a.y() - height) < 0.01 && std::abs(b.y() - height) < 0.01 &&
                           std::abs(c.y() - height) < 0.01;
        area += there ? std::max(0.0, down) : 0.0;
    });
    return area;
}

TEST_F(ImportMap, ClosesBuildingsThatAreAllRoofFromBelow) {
    for (const char* shape : {"dome", "pyramidal", "skillion"}) {
        for (const char* roof_height : {"3", "2.9"}) {
            MapText map;
            const auto id = map.rectangle(-10, -5, 10, 5,
                                          {{"building", "yes"},
                                           {"height", "5"},
                                           {"min_height", "2"},
                                           {"roof:height", roof_height},
                                           {"roof:shape", shape}});
            const Model model = import(map.xml()).model;
            EXPECT_NEAR(underside_at(model, "building/way-" + std::to_string(id), 2.0), 200.0, 0.2)
                << shape << " " << roof_height;
        }
    }
}

TEST_F(ImportMap, PutsTheUndersideOfOpenRoofsAtTheirMinHeight) {
    MapText map;
    const auto low =
        map.rectangle(-10, -5, 10, 5, {{"building", "roof"}, {"height", "4"}, {"min_height", "1.4"}});
    const auto usual = map.rectangle(20, -5, 40, 5, {{"building", "roof"}, {"height", "4"}});
    const Model model = import(map.xml()).model;
    EXPECT_NEAR(underside_at(model, "building/way-" + std::to_string(low), 1.4), 200.0, 0.2);
    EXPECT_NEAR(underside_at(model, "building/way-" + std::to_string(usual), 3.75), 200.0, 0.2);
}

TEST_F(ImportMap, KeepsALowRoofWithoutStoreys) {
    for (const auto& [levels, top] : {std::pair{"0", 7.0}, {"1", 9.0}}) {
        MapText map;
        const auto id = map.rectangle(-10, -5, 10, 5,
                                      {{"building", "yes"},
                                       {"building:levels", "2"},
                                       {"roof:levels", levels},
                                       {"roof:shape", "gabled"}});
        EXPECT_NEAR(bounds_of(import(map.xml()).model, "building/way-" + std::to_string(id)).max.y(), top,
                    0.01);
    }
}

TEST_F(ImportMap, ReportsARoofThatItsFootprintForbids) {
    MapText map;
    map.ring({{0, 0}, {40, 0}, {40, 4}, {4, 4}, {4, 40}, {0, 40}},
             {{"building", "yes"}, {"height", "9"}, {"roof:shape", "gabled"}});
    const ImportedMap imported = import(map.xml());
    EXPECT_TRUE(test::has_code(imported.warnings, "roof-shape"));
}

}  // namespace
}  // namespace campuswalk::scene::osm
