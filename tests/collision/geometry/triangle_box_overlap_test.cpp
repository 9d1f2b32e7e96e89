#include "collision/geometry/triangle_box_overlap.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/dice.h"
#include "tests/support/effort.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;

/// Whether anything of a triangle is left after clipping it at each face of the box in turn.
bool anything_is_left(const Triangle& t, const Vec3& half) {
    std::vector<Vec3> polygon{t.a, t.b, t.c};
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            std::vector<Vec3> inside;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const Vec3& p = polygon[i];
                const Vec3& q = polygon[(i + 1) % polygon.size()];
                const double p_beyond = side * p[axis] - half[axis];
                const double q_beyond = side * q[axis] - half[axis];
                if (p_beyond <= 0.0) {
                    inside.push_back(p);
                }
                if ((p_beyond < 0.0 && q_beyond > 0.0) || (p_beyond > 0.0 && q_beyond < 0.0)) {
                    inside.emplace_back(p + p_beyond / (p_beyond - q_beyond) * (q - p));
                }
            }
            polygon = inside;
        }
    }
    return !polygon.empty();
}

TEST(TriangleBoxOverlap, AgreesWithClipping) {
    Dice dice(54);
    int overlapping = 0;
    int decided = 0;
    const int tries = support::repeats(20000);
    for (int i = 0; i < tries; ++i) {
        const Triangle t = support::random_triangle(dice, dice.in_cube(1.5));
        const Vec3 half(dice.between(0.05, 1.0), dice.between(0.05, 1.0), dice.between(0.05, 1.0));
        const Vec3 slack = Vec3::Constant(1e-9);
        const bool surely = anything_is_left(t, half - slack);
        if (surely == anything_is_left(t, half + slack)) {
            ASSERT_EQ(overlap(t, Box{half}), surely) << i;
            overlapping += surely ? 1 : 0;
            ++decided;
        }
    }
    EXPECT_GT(overlapping, tries / 10);
    EXPECT_LT(overlapping, decided - tries / 10);
}

TEST(TriangleBoxOverlap, IncludesTouching) {
    const Box cube{Vec3(1, 1, 1)};
    EXPECT_TRUE(overlap({{1, 0, 0}, {2, 1, 0}, {2, -1, 0}}, cube)) << "a vertex on a face";
    EXPECT_TRUE(overlap({{1, -3, -3}, {1, 3, -3}, {1, 0, 9}}, cube)) << "a face in a face";
    EXPECT_TRUE(overlap({{2, 0, 0}, {0, 2, 0}, {2, 2, 0}}, cube)) << "an edge on an edge";
    EXPECT_TRUE(overlap({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, cube)) << "a point on a vertex";
    EXPECT_FALSE(overlap({{2.1, 0, 0}, {0, 2.1, 0}, {2, 2, 0}}, cube)) << "an edge beside an edge";
    EXPECT_FALSE(overlap({{1.1, 1, 1}, {1.1, 1, 1}, {1.1, 1, 1}}, cube));
}

}  // namespace
}  // namespace campuswalk::collision
