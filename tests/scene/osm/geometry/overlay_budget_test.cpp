#include "scene/osm/geometry/overlay_budget.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "scene/osm/geometry/plan_geometry.h"
#include "tests/scene/osm/imported_map.h"

namespace campuswalk::scene::osm {
namespace {

using test::MapText;

/// Ends of a segment on a small grid of whole numbers.
using WholeSegment = std::array<std::int64_t, 4>;

int side_of(const WholeSegment& s, std::int64_t x, std::int64_t y) {
    const std::int64_t area = (s[2] - s[0]) * (y - s[1]) - (s[3] - s[1]) * (x - s[0]);
    return area > 0 ? 1 : area < 0 ? -1 : 0;
}

bool is_between(std::int64_t value, std::int64_t a, std::int64_t b) {
    return std::min(a, b) <= value && value <= std::max(a, b);
}

bool is_on(const WholeSegment& s, std::int64_t x, std::int64_t y) {
    return side_of(s, x, y) == 0 && is_between(x, s[0], s[2]) && is_between(y, s[1], s[3]);
}

/// Touch or cross, by whole numbers and by cases.
bool touch_or_cross(const WholeSegment& a, const WholeSegment& b) {
    return is_on(a, b[0], b[1]) || is_on(a, b[2], b[3]) || is_on(b, a[0], a[1]) || is_on(b, a[2], a[3]) ||
           (side_of(a, b[0], b[1]) * side_of(a, b[2], b[3]) < 0 &&
            side_of(b, a[0], a[1]) * side_of(b, a[2], a[3]) < 0);
}

TEST(OverlayBudget, CountsThePairsOfSegmentsThatTouchOrCross) {
    std::mt19937 random(5);
    for (int round = 0; round < 200; ++round) {
        const std::int64_t size = 5 + round % 40;
        std::vector<WholeSegment> whole(10U + static_cast<std::size_t>(round));
        std::vector<Segment> segments;
        for (WholeSegment& segment : whole) {
            for (std::int64_t& value : segment) {
                value = static_cast<std::int64_t>(random() % static_cast<unsigned>(size));
            }
            segments.push_back({Point(static_cast<double>(segment[0]), static_cast<double>(segment[1])),
                                Point(static_cast<double>(segment[2]), static_cast<double>(segment[3]))});
        }
        std::size_t pairs = 0;
        for (std::size_t i = 0; i < whole.size(); ++i) {
            for (std::size_t k = i + 1; k < whole.size(); ++k) {
                pairs += touch_or_cross(whole[i], whole[k]) ? 1U : 0U;
            }
        }
        EXPECT_EQ(OverlayBudget().spend(segments), pairs - std::min(pairs, whole.size())) << round;
    }
}

TEST(OverlayBudget, EndsBySmallOperationsToo) {
    OverlayBudget budget(1'000'000);
    int operations = 0;
    EXPECT_THROW(
        for (;; ++operations) { budget.spend(std::size_t{100}); }, OverlaysTooCostly);
    EXPECT_GT(operations, 1'000);
    EXPECT_LT(operations, 10'000);
}

/// A ring that goes back and forth across a circle: each segment crosses all others.
Ring star(std::size_t vertices) {
    Ring ring;
    for (std::size_t i = 0; i < vertices; ++i) {
        const double turn = 1.0 + 1.0 / static_cast<double>(vertices);
        const double angle = std::numbers::pi * turn * static_cast<double>(i);
        ring.emplace_back(100.0 * std::cos(angle), 100.0 * std::sin(angle));
    }
    return ring;
}

TEST(OverlayBudget, LeavesOutScrawls) {
    const PlanGeometry geometry;
    // What goes around once is inside, what goes around twice isn't.
    const Polygons pentagram = geometry.polygon({{0, 10}, {6, -8}, {-9.5, 3}, {9.5, 3}, {-6, -8}});
    EXPECT_FALSE(contains(pentagram, Point(0, 0)));
    EXPECT_TRUE(contains(pentagram, Point(0, 8)));
    EXPECT_GT(area_of(geometry.polygon(star(13))), 1e3) << "78 crossings";
    EXPECT_TRUE(geometry.polygon(star(101)).empty()) << "for which GEOS would take seven seconds";
    EXPECT_THROW(geometry.polygon(star(1999)), OverlaysTooCostly) << "two million crossings";
}

TEST(OverlayBudget, AllowsTowersOfEqualStoreys) {
    Ring ring;
    for (int i = 0; i < 60; ++i) {
        ring.emplace_back(20.0 * std::cos(0.1047 * i), 20.0 * std::sin(0.1047 * i));
    }
    const Polygons storey = {Polygon{ring, {}}};
    const PlanGeometry geometry;
    const std::vector<const Polygons*> storeys(100, &storey);
    EXPECT_NEAR(area_of(geometry.united(storeys)), area_of(storey), 0.1);
}

class HostileMap : public ImportMap {
protected:
    void expect_too_costly(const MapText& map, const std::string& costly) {
        const auto errors = test::errors_of([&] { import(map.xml()); });
        ASSERT_EQ(errors.size(), 1U);
        EXPECT_EQ(errors[0].code.text(), "bad-size");
        EXPECT_NE(errors[0].message.find("overlap more than can be worked out"), std::string::npos);
        EXPECT_NE(errors[0].message.find(costly + "; leave that out"), std::string::npos)
            << errors[0].message;
        EXPECT_NE(errors[0].message.find("such as --center 48.000000,11.000000 --radius "),
                  std::string::npos);
    }
};

TEST_F(HostileMap, OfLinesThatCrossIsRefused) {
    MapText map;
    std::vector<std::pair<std::int64_t, std::string>> members;
    members.reserve(800);
    for (int i = 0; i < 400; ++i) {
        const double at = -80.0 + 0.4 * i;
        members.emplace_back(map.way({{-80, at}, {80, at}}), "outer");
        members.emplace_back(map.way({{at, -80}, {at, 80}}), "outer");
    }
    const auto id = map.relation(members, {{"type", "multipolygon"}, {"landuse", "grass"}});
    expect_too_costly(map, "relation-" + std::to_string(id));
}

TEST_F(HostileMap, OfEqualRingsIsRefused) {
    MapText map;
    std::vector<std::int64_t> ring;
    ring.reserve(501);
    for (int i = 0; i < 500; ++i) {
        ring.push_back(map.node(50.0 * std::cos(0.01256 * i), 50.0 * std::sin(0.01256 * i)));
    }
    ring.push_back(ring.front());
    std::vector<std::pair<std::int64_t, std::string>> members;
    members.reserve(400);
    for (int i = 0; i < 400; ++i) {
        members.emplace_back(map.way_of(ring), "outer");
    }
    const auto id = map.relation(members, {{"type", "multipolygon"}, {"landuse", "grass"}});
    expect_too_costly(map, "relation-" + std::to_string(id));
}

TEST_F(HostileMap, OfAWayAcrossItselfIsRefused) {
    MapText map(150.0);
    MapText::Points line;
    for (const Point& p : star(2000)) {
        line.emplace_back(p.x(), p.y());
    }
    const auto id = map.way(line, {{"highway", "footway"}});
    expect_too_costly(map, "way-" + std::to_string(id));
}

TEST(OverlayBudget, NamesWhatCostsMost) {
    OverlayBudget budget(1'000'000);
    budget.charge_to("cheap");
    budget.spend(100);
    budget.charge_to("dear");
    budget.spend(200'000);
    budget.charge_to("last");
    try {
        budget.spend(200'000);
        FAIL();
    } catch (const OverlaysTooCostly& cost) {
        EXPECT_EQ(cost.costliest, "dear");
        EXPECT_EQ(cost.its_cost, 600'050U);
        EXPECT_EQ(cost.allowed, 1'000'000U);
        EXPECT_FALSE(cost.one_operation);
    }
}

}  // namespace
}  // namespace campuswalk::scene::osm
