#include "scene/frame/guess_frame.h"

#include "scene/frame/stair_rhythm.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/scene/box_model.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

/// Ten steps with treads of 0.29 m, beginning at x, z.
void add_stairs(Model& model, double x, double z, double riser = 0.17) {
    for (int i = 0; i < 10; ++i) {
        test::add_box(model, "tread", {x, 0, z + 0.29 * i}, {x + 1.5, riser * (i + 1), z + 0.29 * (i + 1)});
    }
}

/// In metres with +Y up: ground, a hall, stairs and two doors.
Model school() {
    Model model;
    test::add_box(model, "ground", {-40, -0.3, -30}, {40, 0, 30});
    test::add_box(model, "hall", {-15, 0, -25}, {15, 8, -5});
    add_stairs(model, 0, 5);
    test::add_box(model, "door_west", {-10, 0, -5}, {-9, 2.1, -4.95});
    test::add_box(model, "door_east", {9, 0, -5}, {10, 2.1, -4.95});
    return model;
}

void transform(Model& model, const Eigen::Matrix4d& by) {
    for (Node& node : model.nodes) {
        node.X_world_node = by * node.X_world_node;
    }
}

Eigen::Matrix4d scaling(double factor) {
    Eigen::Matrix4d by = Eigen::Matrix4d::Identity();
    by.topLeftCorner<3, 3>() *= factor;
    return by;
}

/// Puts +Y where +Z was, so that the model lies on its back.
Eigen::Matrix4d onto_its_back() {
    Eigen::Matrix4d by = Eigen::Matrix4d::Identity();
    by.topLeftCorner<3, 3>() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    return by;
}

TEST(GuessFrame, IsSureOfMetresWithYUp) {
    Model model = school();
    const FrameGuess guess = guess_frame(model);
    EXPECT_EQ(guess.up, UpAxis::y);
    EXPECT_EQ(guess.up_confidence, Confidence::sure);
    EXPECT_EQ(guess.scale, 1.0);
    EXPECT_EQ(guess.scale_confidence, Confidence::sure);
}

TEST(GuessFrame, IsSureOfEachUnitAndAxisWhereverItIs) {
    for (const double unit : {0.01, 0.001, 0.0254, 0.3048, 100.0, 1000.0}) {
        for (const bool lies : {false, true}) {
            for (const bool mirrored : {false, true}) {
                for (const double off : {0.0, 1e5}) {
                    Model model = school();
                    Eigen::Matrix4d by = scaling(1.0 / unit);
                    if (mirrored) {
                        by.col(0) *= -1.0;
                    }
                    by.topRightCorner<3, 1>() = Vector3d(off, 0, -off) / unit;
                    transform(model, by);
                    if (lies) {
                        transform(model, onto_its_back());
                    }
                    const std::vector<Node> before = model.nodes;
                    const FrameGuess guess = guess_frame(model);
                    const std::string which = std::to_string(unit) + (lies ? " on its back" : "") +
                                              (mirrored ? " mirrored" : "") + " at " + std::to_string(off);
                    EXPECT_EQ(guess.up, lies ? UpAxis::z : UpAxis::y) << which;
                    EXPECT_EQ(guess.up_confidence, Confidence::sure) << which;
                    EXPECT_EQ(guess.scale, unit) << which;
                    EXPECT_EQ(guess.scale_confidence, Confidence::sure) << which;
                    for (std::size_t n = 0; n < before.size(); ++n) {
                        EXPECT_EQ(model.nodes[n].X_world_node, before[n].X_world_node) << "turned back";
                    }
                }
            }
        }
    }
}

TEST(GuessFrame, AsksWhatNoUnitExplains) {
    Model model = school();
    transform(model, scaling(1.0 / 16.0));
    const FrameGuess guess = guess_frame(model);
    EXPECT_EQ(guess.scale_confidence, Confidence::unsure);
    EXPECT_GT(guess.scale, 12.0);
    EXPECT_LT(guess.scale, 20.0);
}

TEST(GuessFrame, AsksAboutHousesThatNobodyFitsIn) {
    Model model;
    test::add_box(model, "lawn", {-5, -0.02, -5}, {5, 0, 5});
    for (const double x : {-4.0, -1.0, 2.0}) {
        test::add_box(model, "house", {x, 0, -1}, {x + 1, 0.9, 1});
    }
    const FrameGuess guess = guess_frame(model);
    EXPECT_EQ(guess.scale_confidence, Confidence::unsure);
    EXPECT_EQ(guess.scale, 10.0);
    ASSERT_EQ(guess.measures.size(), 1U);
    EXPECT_EQ(guess.measures[0].kind, MeasureKind::house);
    EXPECT_EQ(guess.measures[0].count, 3U);
    EXPECT_NEAR(guess.measures[0].median, 0.9, 1e-6);
}

TEST(GuessFrame, AsksAboutAHouseLargerThanAny) {
    Model model;
    test::add_box(model, "lawn", {-2500, -10, -2000}, {2500, 0, 2000});
    test::add_box(model, "library", {-500, 0, -400}, {500, 300, 400});
    const FrameGuess guess = guess_frame(model);
    EXPECT_EQ(guess.scale_confidence, Confidence::unsure);
    EXPECT_LT(guess.scale, 0.2);
}

TEST(GuessFrame, TakesFurnitureForNoHouses) {
    Model model;
    test::add_box(model, "floor", {-10, -0.2, -10}, {10, 0, 10});
    for (const double x : {-10.0, 9.8}) {
        test::add_box(model, "wall", {x, 0, -10}, {x + 0.2, 4, 10});
    }
    for (const double x : {-6.0, -2.0, 2.0, 6.0}) {
        test::add_box(model, "Cube", {x, 0, -1}, {x + 1.6, 0.8, 0});
    }
    const FrameGuess guess = guess_frame(model);
    EXPECT_EQ(guess.scale, 1.0);
}

TEST(GuessFrame, SaysNothingOfABox) {
    Model model;
    test::add_box(model, "thing", {0, 0, 0}, {5, 5, 5});
    const FrameGuess guess = guess_frame(model);
    EXPECT_EQ(guess.up_confidence, Confidence::none);
    EXPECT_EQ(guess.scale_confidence, Confidence::none);
    Model empty;
    EXPECT_EQ(guess_frame(empty).scale, 1.0);
}

TEST(GuessFrame, TakesATowerForNoModelOnItsBack) {
    Model model;
    test::add_box(model, "tower", {-10, 0, -10}, {10, 90, 10});
    EXPECT_EQ(guess_frame(model).up, UpAxis::y);
}

TEST(GuessFrame, IsUnsureWhereDoorsAndStairsDisagree) {
    Model model;
    test::add_box(model, "door_west", {-10, 0, -5}, {-9, 2.1, -4.95});
    test::add_box(model, "door_east", {9, 0, -5}, {10, 2.1, -4.95});
    for (int i = 0; i < 10; ++i) {  // louvres, which climb along Z as stairs do in a model on its back
        test::add_box(model, "louvre", {30, -0.29 * (i + 1), 0}, {31.5, -0.29 * i, 0.17 * (i + 1)});
    }
    const FrameGuess guess = guess_frame(model);
    EXPECT_EQ(guess.up, UpAxis::y);
    EXPECT_EQ(guess.up_confidence, Confidence::unsure);
    EXPECT_TRUE(std::ranges::any_of(guess.votes, [](const UpVote& vote) { return vote.y > vote.z; }));
    EXPECT_TRUE(std::ranges::any_of(guess.votes, [](const UpVote& vote) { return vote.z > vote.y; }));
}

TEST(GuessFrame, IsNotSureThatALongHouseAloneLiesOnItsBack) {
    Model model;
    test::add_box(model, "slab", {-30, 0, -10}, {30, 45, 10});
    EXPECT_NE(guess_frame(model).up_confidence, Confidence::sure);
}

TEST(GuessFrame, IsSureOfWhatIsFlat) {
    Model model;
    test::add_box(model, "town", {0, 0, 0}, {80, 60, 4});
    const FrameGuess guess = guess_frame(model);
    EXPECT_EQ(guess.up, UpAxis::z);
    EXPECT_EQ(guess.up_confidence, Confidence::sure);
}

TEST(GuessFrame, AsksAboutOneGateThatIsAsHighAsADoorInFeet) {
    Model model;
    test::add_box(model, "church", {-20, 0, -40}, {20, 30, 0});
    test::add_box(model, "west_door", {-2, 0, 0}, {2, 6.5, 0.2});
    EXPECT_NE(guess_frame(model).scale_confidence, Confidence::sure);
}

TEST(GuessFrame, EndsForSizesBeyondAllScales) {
    Model model = school();
    transform(model, scaling(1e-30));
    EXPECT_EQ(guess_frame(model).scale, 1.0);
}

TEST(StairRhythm, IsFoundInAnyUnitAndOnlyWhereRisesAreAlike) {
    for (const double unit : {1.0, 0.01, 37.0}) {
        Model model;
        add_stairs(model, 0, 0);
        transform(model, scaling(1.0 / unit));
        const auto rhythms = stair_rhythms(level_patches(model, 1e-6 / unit));
        ASSERT_EQ(rhythms.size(), 1U) << unit;
        EXPECT_EQ(rhythms[0].risers, 9U);
        EXPECT_NEAR(rhythms[0].riser * unit, 0.17, 1e-5);
        EXPECT_NEAR(rhythms[0].going * unit, 0.29, 1e-5);
    }
    Model ladder;
    add_stairs(ladder, 0, 0, 0.4);
    EXPECT_TRUE(stair_rhythms(level_patches(ladder, 1e-6)).empty());
}

}  // namespace
}  // namespace campuswalk::scene
