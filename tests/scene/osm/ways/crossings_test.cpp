#include "scene/osm/ways/crossings.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "scene/osm/ways/kerbs.h"
#include "tests/scene/osm/imported_map.h"

namespace campuswalk::scene::osm {
namespace {

using test::MapText;

constexpr double kCarriageway = -0.12;

class Crossings : public ImportMap {
protected:
    /// A road of 8 m that runs east through a node of such tags, and a path across it.
    MapText road_with(const MapText::Tags& node, const MapText::Tags& kerb = {},
                      const MapText::Tags& road = {}) {
        MapText map;
        MapText::Tags tags = {{"highway", "secondary"}, {"width", "8"}};
        tags.insert(tags.end(), road.begin(), road.end());
        middle_ = map.node(0, 0, node);
        road_ = map.way_of({map.node(-90, 0), middle_, map.node(90, 0)}, tags);
        map.way_of({map.node(0, -40), map.node(0, -4, kerb), middle_, map.node(0, 4, kerb), map.node(0, 40)},
                   {{"highway", "footway"}, {"width", "2"}});
        return map;
    }

    std::int64_t middle_ = 0;
    std::int64_t road_ = 0;
};

/// Of all faces of the ground that face up.
double ground_area(const Model& model) {
    double area = 0.0;
    for (const Node& node : model.nodes) {
        area += plan_area(model, node);
    }
    return area;
}

TEST_F(Crossings, FallToTheHeightOfTheirKerb) {
    struct Expected {
        const char* kerb;
        double height;  ///< above the carriageway, metres
    };
    for (const Expected& expected :
         {Expected{"raised", 0.12}, {"lowered", 0.03}, {"flush", 0.0}, {"rolled", 0.06}}) {
        MapText map = road_with({}, {{"barrier", "kerb"}, {"kerb", expected.kerb}});
        const Model model = import(map.xml()).model;
        for (const double side : {1.0, -1.0}) {
            EXPECT_NEAR(top_at(model, 0.1, side * 3.9), kCarriageway, 1e-3) << expected.kerb;
            EXPECT_NEAR(top_at(model, 0.1, side * 4.001), kCarriageway + expected.height, 2e-3)
                << expected.kerb;
            EXPECT_NEAR(top_at(model, 0.1, side * 4.6), 0.5 * (kCarriageway + expected.height), 2e-3)
                << "halfway up: " << expected.kerb;
            EXPECT_NEAR(top_at(model, 0.1, side * 5.3), 0.0, 1e-3) << expected.kerb;
            EXPECT_NEAR(top_at(model, 3.0, side * 4.1), 0.0, 1e-3) << "beside it";
        }
    }
}

TEST_F(Crossings, HaveLoweredKerbsIfNothingIsTagged) {
    MapText crossing = road_with({{"highway", "crossing"}});
    EXPECT_NEAR(top_at(import(crossing.xml()).model, 0.1, 4.001), kCarriageway + 0.03, 2e-3);
    MapText none = road_with({});
    EXPECT_NEAR(top_at(import(none.xml()).model, 0.1, 4.001), 0.0, 2e-3) << "no crossing";
    MapText height = road_with({{"highway", "crossing"}}, {{"kerb:height", "5 cm"}});
    EXPECT_NEAR(top_at(import(height.xml()).model, 0.1, 4.001), kCarriageway + 0.05, 2e-3);
}

TEST_F(Crossings, HaveStripesOfTheirMarkings) {
    struct Expected {
        MapText::Tags tags;
        double area;  ///< of marks, m²
    };
    const double bars = 7 * 0.5 * 3.5;  // half a metre of every metre of 8 m, 3.5 m long
    const double lines = 2 * 0.2 * 8.0;
    for (const Expected& expected :
         {Expected{{{"crossing", "zebra"}}, bars}, Expected{{{"crossing", "uncontrolled"}}, bars},
          Expected{{{"crossing", "traffic_signals"}}, lines}, Expected{{{"crossing", "unmarked"}}, 0.0},
          Expected{{{"crossing:markings", "zebra"}}, bars}, Expected{{{"crossing:markings", "lines"}}, lines},
          Expected{{{"crossing:markings", "no"}, {"crossing", "marked"}}, 0.0}, Expected{{}, 0.0}}) {
        MapText::Tags tags = {{"highway", "crossing"}};
        tags.insert(tags.end(), expected.tags.begin(), expected.tags.end());
        MapText map = road_with(tags);
        const Model model = import(map.xml()).model;
        const Node* marks = find(model, "crossing/node-" + std::to_string(middle_));
        const std::string tagged = expected.tags.empty() ? "nothing" : expected.tags.front().second;
        EXPECT_NEAR(marks == nullptr ? 0.0 : plan_area(model, *marks), expected.area, 0.02) << tagged;
        if (marks != nullptr) {
            EXPECT_NEAR(bounds_of(model, marks->name).max.y(), kCarriageway, 1e-3) << "it lies on the road";
        }
        EXPECT_NEAR(ground_area(model), 40'000.0, 500.0);
    }
}

TEST_F(Crossings, HaveIslandsToWaitOn) {
    MapText map = road_with({{"highway", "crossing"}, {"crossing:island", "yes"}, {"crossing", "zebra"}});
    const Model model = import(map.xml()).model;
    const std::string name = "island/node-" + std::to_string(middle_);
    ASSERT_NE(find(model, name), nullptr);
    EXPECT_NEAR(plan_area(model, *find(model, name)), 2 * 2.4 * 1.5, 0.02);
    EXPECT_NEAR(top_at(model, 2.5, 0.1), 0.0, 1e-3) << "as high as the kerb";
    EXPECT_NEAR(top_at(model, 0.1, 0.1), kCarriageway, 1e-3) << "one walks between them";
}

TEST_F(Crossings, LoseNoGroundToStripesInOneLine) {
    // The stripes and islands of several crossings make holes in one line of the carriageway.
    MapText map;
    std::vector<std::int64_t> road;
    for (int east = -60; east <= 60; east += 20) {
        road.push_back(map.node(
            east, 0,
            {{"highway", "crossing"}, {"crossing", "zebra"}, {"crossing:island", east < 0 ? "yes" : "no"}}));
    }
    map.way_of(road, {{"highway", "secondary"}, {"width", "8"}, {"sidewalk", "both"}});
    const ImportedMap imported = import(map.xml());
    EXPECT_FALSE(test::has_code(imported.warnings, "lost-geometry"));
    Bounds bounds;
    for (const Mesh& mesh : imported.model.meshes) {
        for (const Eigen::Vector3f& p : mesh.positions) {
            bounds.extend(p.cast<double>());
        }
    }
    const Eigen::Vector3d size = bounds.max - bounds.min;
    EXPECT_NEAR(ground_area(imported.model), size.x() * size.z(), 1e-4 * size.x() * size.z());
}

TEST_F(Crossings, AreBesideSidewalks) {
    struct Expected {
        MapText::Tags tags;
        double left;  ///< metres
        double right;
    };
    for (const Expected& expected :
         {Expected{{{"sidewalk", "both"}}, 1.8, 1.8}, Expected{{{"sidewalk", "left"}}, 1.8, 0.0},
          Expected{{{"sidewalk:right", "yes"}, {"sidewalk:left", "no"}}, 0.0, 1.8},
          Expected{{{"sidewalk:both", "yes"}, {"sidewalk:both:width", "2.5"}}, 2.5, 2.5},
          Expected{{{"sidewalk", "separate"}}, 0.0, 0.0}, Expected{{{"sidewalk:both", "separate"}}, 0.0, 0.0},
          Expected{{{"sidewalk", "none"}}, 0.0, 0.0}}) {
        MapText map = road_with({}, {}, expected.tags);
        const Model model = import(map.xml()).model;
        const Node* sidewalk = find(model, "sidewalk/way-" + std::to_string(road_));
        const double area = 180.0 * (expected.left + expected.right);
        EXPECT_NEAR(sidewalk == nullptr ? 0.0 : plan_area(model, *sidewalk), area, 0.01 * area)
            << expected.tags.front().second;
        const auto is_sidewalk = [&](double north) {
            return !heights_at(model, 20.0, north, "sidewalk/").empty();
        };
        EXPECT_EQ(is_sidewalk(4.2), expected.left > 0.0) << "the road runs east";
        EXPECT_EQ(is_sidewalk(-4.2), expected.right > 0.0);
    }
}

}  // namespace
}  // namespace campuswalk::scene::osm
