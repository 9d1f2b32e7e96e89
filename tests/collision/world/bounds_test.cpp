#include "collision/world/bounds.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "collision/mesh/mesh_collider.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;

/// Points of a ball's surface every few degrees.
std::vector<Vec3> ball_points(double radius, const Vec3& center) {
    std::vector<Vec3> points;
    constexpr int kFine = 60;
    for (int i = 0; i <= kFine; ++i) {
        const double polar = std::numbers::pi * i / kFine;
        for (int j = 0; j < 2 * kFine; ++j) {
            const double around = std::numbers::pi * j / kFine;
            points.push_back(center + radius * Vec3(std::sin(polar) * std::cos(around), std::cos(polar),
                                                    std::sin(polar) * std::sin(around)));
        }
    }
    return points;
}

struct SurfacePoints {
    std::vector<Vec3> operator()(const std::shared_ptr<const MeshCollider>& mesh) const {
        std::vector<Vec3> points;
        for (const auto& p : mesh->mesh().positions) {
            points.push_back(p.cast<double>());
        }
        return points;
    }
    std::vector<Vec3> operator()(const Box& box) const {
        std::vector<Vec3> points;
        for (int vertex = 0; vertex < 8; ++vertex) {
            const Vec3 side(vertex & 1 ? 1 : -1, vertex & 2 ? 1 : -1, vertex & 4 ? 1 : -1);
            points.push_back(side.cwiseProduct(box.half_extents));
        }
        return points;
    }
    std::vector<Vec3> operator()(const Sphere& sphere) const {
        return ball_points(sphere.radius, Vec3::Zero());
    }
    std::vector<Vec3> operator()(const Capsule& capsule) const {
        std::vector<Vec3> points = ball_points(capsule.radius, {0, capsule.half_length, 0});
        for (const Vec3& p : ball_points(capsule.radius, {0, -capsule.half_length, 0})) {
            points.push_back(p);
        }
        return points;
    }
    std::vector<Vec3> operator()(const Wheel& wheel) const {
        std::vector<Vec3> points;
        for (int i = 0; i < 720; ++i) {
            const double around = std::numbers::pi * i / 360.0;
            const Vec3 rim = wheel.radius * Vec3(0, std::cos(around), std::sin(around));
            points.push_back(rim + Vec3(wheel.half_width, 0, 0));
            points.push_back(rim - Vec3(wheel.half_width, 0, 0));
        }
        return points;
    }
};

/// The box holds every point of the surface and is hardly larger than the points need.
void expect_tight(const Shape& shape, const Pose& X, double slack) {
    const Aabb box = bounds_of(shape, X);
    Aabb needed;
    for (const Vec3& p : std::visit(SurfacePoints{}, shape)) {
        needed.extend(X * p);
    }
    EXPECT_TRUE((box.min.array() <= needed.min.array()).all());
    EXPECT_TRUE((box.max.array() >= needed.max.array()).all());
    EXPECT_LT((needed.min - box.min).maxCoeff(), slack);
    EXPECT_LT((box.max - needed.max).maxCoeff(), slack);
}

TEST(Bounds, AreTightAroundSolidsAtAnyPose) {
    Dice dice(2);
    for (int i = 0; i < 100; ++i) {
        SCOPED_TRACE(i);
        expect_tight(support::random_solid(dice), support::random_pose(dice, 20.0), 1.5e-3);
    }
}

TEST(Bounds, AreExactForUprightSolids) {
    const Pose X{Mat3::Identity(), Vec3(1, 2, 3)};
    const Aabb box = bounds_of(Box{{1, 2, 3}}, X);
    EXPECT_NEAR((box.min - Vec3(0, 0, 0)).norm(), 0.0, 1e-10);
    EXPECT_NEAR((box.max - Vec3(2, 4, 6)).norm(), 0.0, 1e-10);
    const Aabb wheel = bounds_of(Wheel{0.5, 0.1}, X);
    EXPECT_NEAR((wheel.max - Vec3(1.1, 2.5, 3.5)).norm(), 0.0, 1e-10);
    const Aabb capsule = bounds_of(Capsule{0.5, 1.0}, X);
    EXPECT_NEAR((capsule.max - Vec3(1.5, 3.5, 3.5)).norm(), 0.0, 1e-10);
}

TEST(Bounds, AreTightAroundMeshesFarFromTheOrigin) {
    Dice dice(3);
    for (int i = 0; i < 20; ++i) {
        SCOPED_TRACE(i);
        const auto mesh = std::make_shared<const MeshCollider>(support::random_mesh(dice, 30, 5.0));
        Pose X = support::random_pose(dice, 1.0);
        X.translation += Vec3(450e3, 0, -4e6);
        expect_tight(mesh, X, 1e-5);
    }
}

}  // namespace
}  // namespace campuswalk::collision
