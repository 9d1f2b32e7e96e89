#include "scene/import/source/vertex_normals.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

constexpr double kCrease = 0.766;  // cos 40 deg

/// Two squares that share the edge along z: one flat, the other rising by `angle`. Vertices are not shared.
struct Fold {
    std::vector<Eigen::Vector3f> positions;
    std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 2, 1}, {3, 4, 5}};

    explicit Fold(double angle) {
        const auto x = static_cast<float>(std::cos(angle));
        const auto y = static_cast<float>(std::sin(angle));
        positions = {{0, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, 0}, {0, 0, 1}, {x, y, 0}};
    }
};

TEST(VertexNormals, AreSmoothAcrossAGentleEdge) {
    const Fold fold(-0.3);
    const auto normals = vertex_normals(fold.positions, fold.triangles, kCrease);
    ASSERT_EQ(normals.size(), 6U);
    // At the shared edge, the normals of both faces are halfway between the two; elsewhere each is its
    // face's.
    const double half = 0.15;
    const Eigen::Vector3f between(static_cast<float>(std::sin(half)), static_cast<float>(std::cos(half)), 0);
    for (const std::size_t vertex : {0U, 2U, 3U, 4U}) {
        EXPECT_LT((normals[vertex].cwiseAbs() - between).norm(), 1e-5F) << vertex << ": " << normals[vertex];
    }
    EXPECT_LT((normals[1].cwiseAbs() - Eigen::Vector3f::UnitY()).norm(), 1e-6F);
}

TEST(VertexNormals, KeepSharpEdges) {
    const Fold fold(-std::numbers::pi / 3);
    const auto normals = vertex_normals(fold.positions, fold.triangles, kCrease);
    for (std::size_t vertex = 0; vertex < 3; ++vertex) {
        EXPECT_LT((normals[vertex].cwiseAbs() - Eigen::Vector3f::UnitY()).norm(), 1e-6F);
    }
}

TEST(VertexNormals, AreFlatOnRequest) {
    const Fold fold(-0.3);
    const auto normals = vertex_normals(fold.positions, fold.triangles, 1.0);
    EXPECT_EQ(normals[0], normals[1]);
    EXPECT_EQ(normals[0], normals[2]);
    EXPECT_NE(normals[0], normals[3]);
}

TEST(VertexNormals, PointUpForDegenerateTriangles) {
    const std::vector<Eigen::Vector3f> positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 1, 2}};
    for (const Eigen::Vector3f& normal : vertex_normals(positions, triangles, kCrease)) {
        EXPECT_EQ(normal, Eigen::Vector3f::UnitY());
    }
}

}  // namespace
}  // namespace campuswalk::scene
