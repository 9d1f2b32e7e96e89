#include "scene/osm/objects/barriers.h"

#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "scene/osm/meaning/gates.h"
#include "tests/scene/osm/imported_map.h"

namespace campuswalk::scene::osm {
namespace {

using test::MapText;

class Barriers : public ImportMap {
protected:
    /// A fence through the middle in a direction, with a gate there, and a path across it if it has a width.
    MapText fence_with_gate(double degrees, const MapText::Tags& gate, const char* path_width = nullptr) {
        const double c = std::cos(degrees * std::numbers::pi / 180.0);
        const double s = std::sin(degrees * std::numbers::pi / 180.0);
        along_ = Eigen::Vector2d(c, s);
        MapText map;
        MapText::Tags tags = {{"barrier", "gate"}};
        tags.insert(tags.end(), gate.begin(), gate.end());
        const auto middle = map.node(0, 0, tags);
        map.way_of({map.node(-30 * c, -30 * s), middle, map.node(30 * c, 30 * s)}, {{"barrier", "fence"}});
        map.way({{-80, -80}, {80, -80}}, {{"highway", "footway"}});
        if (path_width != nullptr) {
            map.way_of({map.node(30 * s, -30 * c), middle, map.node(-30 * s, 30 * c)},
                       {{"highway", "service"}, {"width", path_width}});
        }
        return map;
    }
    /// Metres along the fence between -4 and 4 where nothing stands.
    double free_length(const Model& model) const {
        double length = 0.0;
        for (int i = 0; i < 160; ++i) {
            const Eigen::Vector2d p = (-4.0 + 0.05 * i) * along_;
            length += top_at(model, p.x(), p.y()) > 0.5 ? 0.0 : 0.05;
        }
        return length;
    }

    Eigen::Vector2d along_ = {1, 0};
};

TEST_F(Barriers, AreClosedAtLockedGates) {
    for (const double degrees : {0.0, 90.0, 45.0, -30.0}) {
        for (const char* width : {static_cast<const char*>(nullptr), "4"}) {
            for (const MapText::Tags& tags : {MapText::Tags{{"locked", "yes"}},
                                              {{"access", "private"}},
                                              {{"foot", "no"}, {"access", "yes"}}}) {
                MapText map = fence_with_gate(degrees, tags, width);
                EXPECT_LT(free_length(import(map.xml()).model), 0.11)
                    << degrees << " " << tags.front().first << (width == nullptr ? "" : " with a path");
            }
        }
    }
}

TEST_F(Barriers, AreOpenAtGatesForWalkers) {
    for (const double degrees : {0.0, 90.0, 45.0}) {
        for (const MapText::Tags& tags : {MapText::Tags{}, {{"access", "private"}, {"foot", "yes"}}}) {
            MapText map = fence_with_gate(degrees, tags, "4");
            EXPECT_NEAR(free_length(import(map.xml()).model), 4.0, 0.3) << degrees << ": as wide as the path";
        }
        MapText none = fence_with_gate(degrees, {});
        EXPECT_NEAR(free_length(import(none.xml()).model), 1.8, 0.3) << degrees;
    }
}

TEST_F(Barriers, HaveGatesAsWideAsTagged) {
    for (const double degrees : {0.0, 45.0}) {
        for (const char* path_width : {static_cast<const char*>(nullptr), "4"}) {
            MapText narrow = fence_with_gate(degrees, {{"width", "0.9"}}, path_width);
            EXPECT_NEAR(free_length(import(narrow.xml()).model), 0.9, 0.25) << degrees;
            MapText physical =
                fence_with_gate(degrees, {{"width", "3"}, {"maxwidth:physical", "1.4"}}, path_width);
            EXPECT_NEAR(free_length(import(physical.xml()).model), 1.4, 0.25) << degrees;
        }
    }
}

TEST_F(Barriers, ReachFarBeyondTheMap) {
    MapText map;
    map.way({{0, 0}, {0, 2'000'000}}, {{"barrier", "fence"}});
    map.way({{-50, 0}, {50, 0}}, {{"highway", "footway"}});
    const Model model = import(map.xml()).model;
    EXPECT_LT(bounds_of(model, "fence/way-3").max.norm(), 500.0);
}

TEST_F(Barriers, LeaveRoomToStart) {
    for (const auto& [key, value] : {std::pair{"amenity", "bench"}, {"barrier", "gate"}}) {
        MapText map;
        const auto middle = map.node(0.2, 0, {{key, value}, {"locked", "yes"}});
        map.way_of({map.node(-40, 0), middle, map.node(40, 0)}, {{"highway", "footway"}});
        const ImportedMap imported = import(map.xml());
        const DraftSpawn& start = imported.draft.spawns.front();
        ASSERT_EQ(start.name, "start");
        EXPECT_GT(std::abs(start.at.x() - 0.2), 0.5) << value;
        EXPECT_LT(std::abs(start.at.x()), 10.0) << "the next place on the path";
    }
    MapText closed;
    closed.rectangle(-15, -15, 15, 15, {{"building", "yes"}});
    const Eigen::Vector3d at = import(closed.xml()).draft.spawns.front().at;
    EXPECT_GT(std::max(std::abs(at.x()), std::abs(at.z())), 15.5) << "outside, though there is no path";
}

TEST_F(Barriers, HaveGatesThatAreWays) {
    const std::vector<std::pair<MapText::Tags, bool>> gates = {
        {{{"barrier", "gate"}}, true},
        {{{"barrier", "lift_gate"}}, true},
        {{{"barrier", "gate"}, {"locked", "yes"}}, false},
        {{{"barrier", "gate"}, {"access", "no"}}, false}};
    for (const bool fence_goes_on : {false, true}) {
        for (const auto& [tags, open] : gates) {
            MapText map;
            const auto west = map.node(-2, 0);
            const auto east = map.node(2, 0);
            const auto gate = map.way_of({west, east}, tags);
            if (fence_goes_on) {
                map.way_of({map.node(-30, 0), west, east, map.node(30, 0)}, {{"barrier", "fence"}});
            } else {
                map.way_of({map.node(-30, 0), west}, {{"barrier", "fence"}});
                map.way_of({east, map.node(30, 0)}, {{"barrier", "fence"}});
            }
            map.way({{0, -40}, {0, 40}}, {{"highway", "service"}});
            const ImportedMap imported = import(map.xml());
            EXPECT_NE(find(imported.model, "gate/way-" + std::to_string(gate)), nullptr);
            EXPECT_NEAR(free_length(imported.model), open ? 4.0 : 0.0, 0.3)
                << tags.back().first << (fence_goes_on ? " in a fence that goes on" : "");
            const auto spawn =
                std::ranges::find(imported.draft.spawns, "gate-" + std::to_string(gate), &DraftSpawn::name);
            ASSERT_NE(spawn, imported.draft.spawns.end());
            EXPECT_NEAR(std::abs(spawn->at.z()), 2.0, 0.01);
        }
    }
}

TEST_F(Barriers, HaveRowsOfBollardsAndBlocks) {
    for (const char* kind : {"bollard", "block"}) {
        MapText map;
        const auto row = map.way({{-6, 0}, {6, 0}}, {{"barrier", kind}});
        const auto one = map.rectangle(20, 20, 20.8, 20.8, {{"barrier", kind}});
        map.way({{-80, -80}, {80, -80}}, {{"highway", "footway"}});
        const Model model = import(map.xml()).model;
        const std::string name = std::string(kind) + "/way-" + std::to_string(row);
        ASSERT_NE(find(model, name), nullptr);
        for (int i = 0; i <= 8; ++i) {
            EXPECT_GT(top_at(model, -6.0 + 1.5 * i, 0.01, name), 0.6) << i;
            EXPECT_TRUE(i == 8 || std::isnan(top_at(model, -5.25 + 1.5 * i, 0.01, name))) << i;
        }
        EXPECT_GT(top_at(model, 20.4, 20.41, std::string(kind) + "/way-" + std::to_string(one)), 0.6);
    }
}

TEST_F(Barriers, OfUnknownKindsAreCounted) {
    MapText map;
    const auto first = map.way({{-6, 0}, {6, 0}}, {{"barrier", "ditch"}});
    map.way({{-6, 9}, {6, 9}}, {{"barrier", "ditch"}});
    map.way({{-6, 19}, {6, 19}}, {{"barrier", "chain"}});
    map.way({{-80, -80}, {80, -80}}, {{"highway", "footway"}});
    const ImportedMap imported = import(map.xml());
    const auto warning =
        std::ranges::find(imported.warnings, DiagnosticCode("unknown-barrier"), &Diagnostic::code);
    ASSERT_NE(warning, imported.warnings.end());
    EXPECT_TRUE(warning->message.starts_with("2 ways (the first: way " + std::to_string(first) +
                                             ", barrier=ditch) are barriers"));
}

}  // namespace
}  // namespace campuswalk::scene::osm
