#include "engine/render/geometry/avatar_figure.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render {
namespace {

using Eigen::Vector3d;
using test::avatar_at;

constexpr double kHalfTurn = 3.141592653589793;

Eigen::AlignedBox3d box_of(const FigureMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Vertex& v : mesh.vertices) {
        box.extend(Vector3d(v.position[0], v.position[1], v.position[2]));
    }
    return box;
}

TEST(AvatarFigure, StandsOnItsFootPointWithTheProfilesHeight) {
    for (const double height : {1.2, 1.8, 2.0}) {
        AvatarProfile profile;
        profile.height = height;
        const auto box = box_of(make_figure(avatar_at({10, 5, -3}, 0.7), profile, 0.0, {9, 5, -3}));
        EXPECT_NEAR(box.min().y(), 0.0, 0.01 * height);
        EXPECT_NEAR(box.max().y(), height, 0.01 * height);
        EXPECT_NEAR(box.center().x(), 1.0, 0.1) << "relative to the given origin";
        EXPECT_LT((box.max() - box.min()).x(), 0.6 * height);
    }
}

TEST(AvatarFigure, FacesItsYaw) {
    const AvatarProfile profile;
    const FigureMesh north = make_figure(avatar_at(Vector3d::Zero(), 0.0), profile, 0.3, Vector3d::Zero());
    const FigureMesh south =
        make_figure(avatar_at(Vector3d::Zero(), kHalfTurn), profile, 0.3, Vector3d::Zero());
    ASSERT_EQ(north.vertices.size(), south.vertices.size());
    for (std::size_t i = 0; i < north.vertices.size(); ++i) {
        EXPECT_NEAR(north.vertices[i].position[0], -south.vertices[i].position[0], 1e-5);
        EXPECT_NEAR(north.vertices[i].position[2], -south.vertices[i].position[2], 1e-5);
    }
    // The rucksack sticks out behind, which is +Z for an avatar that looks along -Z.
    EXPECT_GT(box_of(north).max().z(), -box_of(north).min().z());
}

TEST(AvatarFigure, StrideMovesTheFeetApart) {
    const AvatarProfile profile;
    const auto depth = [&](double stride) {
        return box_of(make_figure(avatar_at(Vector3d::Zero(), 0.0), profile, stride, Vector3d::Zero()))
            .sizes()
            .z();
    };
    EXPECT_GT(depth(0.5 * kHalfTurn), depth(0.0) + 0.2);
}

TEST(AvatarFigure, HasOutwardTrianglesAndUnitNormals) {
    const AvatarProfile profile;
    const FigureMesh mesh = make_figure(avatar_at(Vector3d::Zero(), 0.0), profile, 0.0, Vector3d::Zero());
    ASSERT_EQ(mesh.indices.size() % 3, 0U);
    std::size_t inwards = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::array<Vector3d, 3> p;
        Vector3d normal = Vector3d::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_LT(mesh.indices[i + k], mesh.vertices.size());
            const Vertex& v = mesh.vertices[mesh.indices[i + k]];
            p[k] = {v.position[0], v.position[1], v.position[2]};
            const Vector3d n(v.normal[0], v.normal[1], v.normal[2]);
            EXPECT_NEAR(n.norm(), 32767.0, 3.0);
            normal += n;
        }
        inwards += (p[1] - p[0]).cross(p[2] - p[0]).dot(normal) < -1e-6 ? 1U : 0U;
    }
    EXPECT_EQ(inwards, 0U);
}

}  // namespace
}  // namespace campuswalk::engine::render
