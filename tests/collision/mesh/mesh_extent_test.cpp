#include "collision/mesh/mesh_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/dice.h"

namespace campuswalk::collision {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::vector<Eigen::Vector3f> scattered(std::size_t count) {
    support::Dice dice(3);
    std::vector<Eigen::Vector3f> positions;
    for (std::size_t i = 0; i < count; ++i) {
        positions.push_back(dice.in_cube(10.0).cast<float>());
    }
    return positions;
}

TEST(MeshExtent, AgreesWithALoopOverThePositions) {
    for (const std::size_t count : {1U, 2U, 15U, 16U, 17U, 48U, 50U, 333U}) {
        const std::vector<Eigen::Vector3f> positions = scattered(count);
        Aabb box;
        float largest = 0.0F;
        for (const Eigen::Vector3f& p : positions) {
            box.extend(p.cast<double>());
            largest = std::max(largest, p.cwiseAbs().maxCoeff());
        }
        EXPECT_EQ(box_of(positions).min, box.min) << count;
        EXPECT_EQ(box_of(positions).max, box.max) << count;
        EXPECT_EQ(largest_coordinate(positions), largest) << count;
    }
    EXPECT_TRUE(box_of({}).empty());
    EXPECT_EQ(largest_coordinate({}), 0.0F);
}

TEST(MeshExtent, IsInfiniteIfACoordinateIsNotFinite) {
    for (const float bad : {kInfinity, -kInfinity, std::nanf(""), -std::nanf("")}) {
        for (std::size_t at = 0; at < 60; ++at) {
            std::vector<Eigen::Vector3f> positions = scattered(20);
            positions[at / 3][static_cast<Eigen::Index>(at % 3)] = bad;
            EXPECT_EQ(largest_coordinate(positions), kInfinity) << bad << " at " << at;
        }
    }
}

TEST(MeshExtent, FindsTheHighestVertexIndex) {
    std::vector<std::array<std::uint32_t, 3>> triangles(7, {1, 2, 3});
    EXPECT_EQ(highest_vertex(triangles), 3U);
    triangles[5][0] = 0xFFFFFFFE;
    EXPECT_EQ(highest_vertex(triangles), 0xFFFFFFFEU);
    EXPECT_EQ(highest_vertex({}), 0U);
}

}  // namespace
}  // namespace campuswalk::collision
