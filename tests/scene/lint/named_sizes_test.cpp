#include "scene/lint/named_sizes.h"

#include <gtest/gtest.h>

#include "tests/scene/box_model.h"

namespace campuswalk::scene {
namespace {

std::vector<ModelLint> lints_of(const Model& model) {
    return lint_named_sizes(model, report(model).nodes);
}

/// Ten steps of 0.3 m depth.
void add_stairs(Model& model, const std::string& name, double riser) {
    const std::size_t group = test::add_group(model, name);
    for (int i = 0; i < 10; ++i) {
        test::add_box(model, "tread", {0, 0, 0.3 * i}, {1, riser * (i + 1), 0.3 * (i + 1)},
                      static_cast<int>(group));
    }
}

TEST(NamedSizes, ReportsADoorOfFiveCentimetres) {
    Model model;
    test::add_box(model, "hall", {0, 0, 0}, {0.5, 0.1, 0.5});
    test::add_box(model, "Door_01", {0.2, 0, 0}, {0.22, 0.05, 0.001});
    const auto lints = lints_of(model);
    ASSERT_EQ(lints.size(), 1U);
    EXPECT_EQ(lints[0].code.text(), "door-size");
    EXPECT_NE(lints[0].message.find("'Door_01' of 0.05 m"), std::string::npos) << lints[0].message;
    ASSERT_EQ(lints[0].places.size(), 1U);
    EXPECT_TRUE(lints[0].places[0].at.isApprox(Eigen::Vector3d(0.21, 0, 0.0005), 1e-5));
}

TEST(NamedSizes, ReportsADoorLyingOnTheGround) {
    Model model;
    test::add_box(model, "door", {0, 0, 0}, {0.9, 0.05, 2.1});
    const auto lints = lints_of(model);
    ASSERT_EQ(lints.size(), 1U);
    EXPECT_NE(lints[0].message.find("`up: z`"), std::string::npos) << lints[0].message;
}

TEST(NamedSizes, AcceptsDoorsOfHousesCupboardsAndCathedrals) {
    Model model;
    test::add_box(model, "door", {0, 0, 0}, {0.9, 2.1, 0.05});
    test::add_box(model, "cupboard_door", {2, 1, 0}, {2.4, 1.5, 0.02});
    test::add_box(model, "west_door", {4, 0, 0}, {8, 5.5, 0.3});
    test::add_box(model, "door_frame", {9, 0, 0}, {9.1, 0.1, 0.1});
    EXPECT_TRUE(lints_of(model).empty());
}

TEST(NamedSizes, TakesStoreysFarApartForNoUnit) {
    for (const double storey : {3.0, 4.5, 8.5}) {  // landings, as a stair without treads has
        Model model;
        add_stairs(model, "Stairs", storey);
        ASSERT_EQ(lints_of(model).size(), 1U);
        EXPECT_EQ(lints_of(model)[0].code.text(), "stair-riser");
    }
}

TEST(NamedSizes, ReportsRisersTooHighToClimb) {
    for (const double riser : {0.17, 0.45, 2.0}) {
        Model model;
        add_stairs(model, "Stairs", riser);
        const auto lints = lints_of(model);
        ASSERT_EQ(lints.size(), riser > 0.3 ? 1U : 0U) << riser;
        if (!lints.empty()) {
            EXPECT_EQ(lints[0].code.text(), "stair-riser");
            EXPECT_EQ(lints[0].places.at(0).node, "Stairs");
        }
    }
    Model model;
    test::add_box(model, "steps", {0, 0, 0}, {1, 2, 1});  // a single step
    EXPECT_TRUE(lints_of(model).empty());
    EXPECT_EQ(riser_of({}), 0.0);
    EXPECT_NEAR(riser_of({0.5, 0.0, 0.001, 1.0, 0.5, 1.5, 2.9}), 0.5, 1e-9);  // the last is a rail
}

}  // namespace
}  // namespace campuswalk::scene
