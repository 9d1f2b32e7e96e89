#include "collision/hybrid/hybrid_tree_split.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/mesh_pieces.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

struct Sides {
    std::vector<std::uint32_t> left;
    std::vector<std::uint32_t> right;
};

/// Splits all of the mesh, with each side sorted.
Sides sides_of(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    const std::size_t left = split(mesh, order, fit_inner_box(mesh, order));
    const auto middle = order.begin() + static_cast<std::ptrdiff_t>(left);
    Sides sides{{order.begin(), middle}, {middle, order.end()}};
    std::sort(sides.left.begin(), sides.left.end());
    std::sort(sides.right.begin(), sides.right.end());
    return sides;
}

TEST(HybridTreeSplit, KeepsEveryTriangleAndLeavesEnoughOnBothSides) {
    support::Dice dice(330);
    for (int i = 0; i < 300; ++i) {
        const int count = 2 + dice.below(200);
        const Sides sides = sides_of(support::random_mesh(dice, count, dice.between(0.0, 5.0)));
        const std::size_t least = std::max<std::size_t>(1, static_cast<std::size_t>(count) / kMinSideDivisor);
        EXPECT_GE(sides.left.size(), least);
        EXPECT_GE(sides.right.size(), least);
        std::vector<std::uint32_t> all;
        std::merge(sides.left.begin(), sides.left.end(), sides.right.begin(), sides.right.end(),
                   std::back_inserter(all));
        std::vector<std::uint32_t> expected(static_cast<std::size_t>(count));
        std::iota(expected.begin(), expected.end(), 0U);
        EXPECT_EQ(all, expected);
    }
}

TEST(HybridTreeSplit, DoesNotSplitOffAFewDistantTriangles) {
    for (const double far : {-1000.0, 1000.0}) {
        TriangleMesh mesh;
        for (int i = 0; i < 64; ++i) {
            const double x = i < 2 ? far + i : 0.1 * i;
            support::add_triangle(mesh, {x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0});
        }
        const Sides sides = sides_of(mesh);
        EXPECT_GE(sides.left.size(), 64 / kMinSideDivisor);
        EXPECT_GE(sides.right.size(), 64 / kMinSideDivisor);
    }
}

TEST(HybridTreeSplit, CutsInTheGapBetweenTwoClusters) {
    TriangleMesh mesh;
    for (int i = 0; i < 20; ++i) {
        const double x = i < 7 ? 0.1 * i : 50.0 + 0.1 * i;
        support::add_triangle(mesh, {x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0});
    }
    const Sides sides = sides_of(mesh);
    EXPECT_EQ(std::min(sides.left.size(), sides.right.size()), 7U);
    EXPECT_EQ(std::min(sides.left.front(), sides.right.front()), 0U);
    EXPECT_EQ(std::max(sides.left.front(), sides.right.front()), 7U);
}

TEST(HybridTreeSplit, CutsAcrossAShorterAxisIfThatSeparates) {
    // Two long plates, one above the other: across their length both sides would be as high as both plates.
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) {
        const double y = i < 4 ? 0.0 : 3.0;
        const double z = 0.1 * (i % 4);
        support::add_triangle(mesh, {-5, y, z}, {5, y, z}, {0, y, z + 0.1});
    }
    const Sides sides = sides_of(mesh);
    EXPECT_EQ(sides.left.size(), 4U);
    EXPECT_TRUE(sides.left.back() == 3U || sides.right.back() == 3U);
}

TEST(HybridTreeSplit, HalvesIfNoCutHelps) {
    TriangleMesh line;
    for (int i = 0; i < 10; ++i) {
        support::add_triangle(line, {1.0 * i, 0, 0}, {i + 1.0, 0, 0}, {i + 0.5, 0, 0});
    }
    const Sides sides = sides_of(line);
    EXPECT_EQ(sides.left.size(), 5U);
    EXPECT_TRUE(sides.left.back() == 4U || sides.right.back() == 4U) << "neighbours stay together";

    TriangleMesh stack;
    for (int i = 0; i < 9; ++i) {
        support::add_triangle(stack, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    }
    EXPECT_EQ(sides_of(stack).left, (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

}  // namespace
}  // namespace campuswalk::collision
