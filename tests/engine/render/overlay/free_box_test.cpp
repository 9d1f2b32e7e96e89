#include "engine/render/overlay/free_box.h"

#include <array>

#include <gtest/gtest.h>

namespace campuswalk::engine::render::test {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

const AlignedBox2d kArea(Vector2d(0, 0), Vector2d(100, 100));
const Vector2d kHalf(10, 5);
const std::array<Vector2d, 3> kShifts = {{{0, 0}, {2, 0}, {0, -2}}};

TEST(FreeBox, IsTheFirstThatOverlapsNothing) {
    std::vector<AlignedBox2d> taken;
    for (const Vector2d& expected : {Vector2d(50, 50), Vector2d(70, 50), Vector2d(50, 40)}) {
        const auto box = free_box(kArea, {50, 50}, kHalf, kShifts, taken);
        ASSERT_TRUE(box);
        EXPECT_EQ(box->center(), expected);
        EXPECT_EQ(box->sizes(), Vector2d(20, 10));
        taken.push_back(*box);
    }
    EXPECT_FALSE(free_box(kArea, {50, 50}, kHalf, kShifts, taken));
}

TEST(FreeBox, StaysInTheArea) {
    EXPECT_EQ(free_box(kArea, {95, 50}, kHalf, kShifts, {}), std::nullopt);
    const auto raised = free_box(kArea, {50, 98}, kHalf, kShifts, {});
    ASSERT_TRUE(raised);
    EXPECT_EQ(raised->center(), Vector2d(50, 88));
}

}  // namespace
}  // namespace campuswalk::engine::render::test
