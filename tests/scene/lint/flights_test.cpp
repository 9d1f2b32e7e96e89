#include "scene/lint/flights.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scene/box_model.h"

namespace campuswalk::scene {
namespace {

using testing::DoubleNear;
using testing::Each;

constexpr double kRounding = 1e-6;  // of float32

/// `count` boxes that reach down to the ground, each the tread of a step, from z = 0 on.
std::size_t add_steps(Model& model, int count, double first_riser, double riser, double depth) {
    const auto house = static_cast<int>(test::add_group(model, "house"));
    const std::size_t group = test::add_group(model, "stair", house);
    for (int i = 0; i < count; ++i) {
        test::add_box(model, "step-" + std::to_string(i), {0, 0, depth * i},
                      {1.2, first_riser + riser * i, depth * (i + 1)}, static_cast<int>(group));
    }
    return group;
}

TEST(Flights, AreMeasuredFromTheFloorToTheLanding) {
    Model model;
    test::add_box(model, "floor", {-10, -0.2, -10}, {10, 0, 10});
    const std::size_t stair = add_steps(model, 9, 0.17, 0.17, 0.28);
    test::add_box(model, "landing", {0, 0, 9 * 0.28}, {1.2, 1.7, 5});
    const std::vector<Flight> flights = find_flights(model);
    ASSERT_EQ(flights.size(), 1U);
    EXPECT_EQ(flights[0].node, stair);
    EXPECT_EQ(flights[0].risers.size(), 10U);
    EXPECT_THAT(flights[0].risers, Each(DoubleNear(0.17, kRounding)));
    EXPECT_NEAR(flights[0].tread_depth, 0.28, kRounding);
    EXPECT_NEAR(flights[0].width, 1.2, kRounding);
    EXPECT_TRUE(flights[0].foot.isApprox(Eigen::Vector3d(0.6, 0.17, 0.14), kRounding)) << flights[0].foot;
}

TEST(Flights, TellAnOddFirstRiser) {
    Model model;
    test::add_box(model, "floor", {-10, -0.2, -10}, {10, 0, 10});
    add_steps(model, 6, 0.45, 0.16, 0.3);
    const std::vector<Flight> flights = find_flights(model);
    ASSERT_EQ(flights.size(), 1U);
    EXPECT_NEAR(flights[0].risers.front(), 0.45, kRounding);
    EXPECT_NEAR(usual_riser(flights[0]), 0.16, kRounding);
    EXPECT_EQ(flights[0].risers.size(), 6U);  // there is no landing
}

TEST(Flights, MayTurn) {
    constexpr int kSteps = 12;
    constexpr double kTurn_deg = 20.0;
    constexpr double kRadius = 1.0;
    Model model;
    for (int i = 0; i < kSteps; ++i) {
        const double angle = i * kTurn_deg * std::numbers::pi / 180.0;
        test::add_turned_box(model, "slab", {kRadius * std::cos(angle), 0.18 * i, -kRadius * std::sin(angle)},
                             {0.9, 0.04, 0.3}, i * kTurn_deg);
    }
    const std::vector<Flight> flights = find_flights(model);
    ASSERT_EQ(flights.size(), 1U);
    EXPECT_EQ(flights[0].risers.size(), kSteps - 1U);
    EXPECT_THAT(flights[0].risers, Each(DoubleNear(0.18, kRounding)));
}

TEST(Flights, AreTwoSideBySide) {
    Model model;
    for (int i = 0; i < 5; ++i) {  // up and, beside it, on and up the other way
        test::add_box(model, "up", {0, 0, 0.3 * i}, {1, 0.17 * (i + 1), 0.3 * (i + 1)});
        test::add_box(model, "back", {1.1, 0, 1.5 - 0.3 * (i + 1)}, {2.1, 0.17 * (i + 6), 1.5 - 0.3 * i});
    }
    const std::vector<Flight> flights = find_flights(model);
    ASSERT_EQ(flights.size(), 2U);
    EXPECT_NEAR(flights[0].foot.x(), 0.5, kRounding);
    EXPECT_NEAR(flights[1].foot.x(), 1.6, kRounding);
}

TEST(Flights, AreNoShelvesFloorsOrTables) {
    Model model;
    test::add_box(model, "floor", {-10, -0.2, -10}, {10, 0, 10});
    for (int i = 0; i < 6; ++i) {
        test::add_box(model, "board", {0, 0.3 * i, 0}, {1, 0.3 * i + 0.02, 0.3});
    }
    test::add_box(model, "bench", {3, 0, 0}, {5, 0.45, 0.5});
    test::add_box(model, "table", {3, 0, 0.6}, {5, 0.75, 1.3});
    EXPECT_TRUE(find_flights(model).empty());
}

}  // namespace
}  // namespace campuswalk::scene
