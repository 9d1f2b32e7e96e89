#include "collision/geometry/ray.h"

#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/plain_solids.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;
using support::Line;
using support::vertices_of;

std::optional<double> hit_any(const Ray& ray, const Shape& shape) {
    return std::visit(
        [&](const auto& solid) -> std::optional<double> {
            if constexpr (std::is_same_v<std::decay_t<decltype(solid)>,
                                         std::shared_ptr<const MeshCollider>>) {
                return std::nullopt;
            } else {
                return hit(ray, solid);
            }
        },
        shape);
}

TEST(RayOnTriangle, AgreesWithThePlainFormula) {
    Dice dice(30);
    int hits = 0;
    for (int i = 0; i < 50000; ++i) {
        const Triangle t{dice.in_cube(1.0), dice.in_cube(1.0), dice.in_cube(1.0)};
        const Ray ray{dice.in_cube(2.0), dice.in_cube(2.0)};
        const auto ours = hit(ray, t);
        const auto plain = support::first_intersection(Line{ray.from, ray.to}, vertices_of(t));
        ASSERT_EQ(ours.has_value(), plain.has_value()) << i;
        if (ours) {
            ASSERT_NEAR(*ours, *plain, 1e-9) << i;
            ++hits;
        }
    }
    EXPECT_GT(hits, 1000);
}

TEST(RayOnTriangle, HitsBothSides) {
    const Triangle t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_EQ(hit({{0.2, 0.2, 1}, {0.2, 0.2, -3}}, t), 0.25);
    EXPECT_EQ(hit({{0.2, 0.2, -3}, {0.2, 0.2, 1}}, t), 0.75);
    EXPECT_EQ(hit({{0.2, 0.2, 1}, {0.2, 0.2, 0}}, t), 1.0) << "at its very end";
    EXPECT_EQ(hit({{0.2, 0.2, 0}, {0.2, 0.2, 1}}, t), 0.0) << "at its very start";
    EXPECT_EQ(hit({{0.2, 0.2, 1}, {0.2, 0.2, 0.001}}, t), std::nullopt);
    EXPECT_EQ(hit({{0.7, 0.7, 1}, {0.7, 0.7, -1}}, t), std::nullopt);
}

TEST(RayOnTriangle, MissesDegenerateAndParallelTriangles) {
    const Ray ray{{0.5, 0.5, 1}, {0.5, 0.5, -1}};
    EXPECT_EQ(hit(ray, Triangle{{0.5, 0.5, 0}, {0.5, 0.5, 0}, {0.5, 0.5, 0}}), std::nullopt);
    EXPECT_EQ(hit(ray, Triangle{{0, 0, 0}, {1, 1, 0}, {0.5, 0.5, 0}}), std::nullopt);
    EXPECT_EQ(hit({{0, 0, 0}, {0, 0, 0}}, Triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}), std::nullopt);
    EXPECT_EQ(hit({{-1, 0, 0}, {1, 0, 0}}, Triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}), std::nullopt)
        << "in its own plane";
}

/// Rays at the shared edges of a bumpy fan of triangles must never slip through.
TEST(RayOnTriangle, NeverSlipsBetweenAdjacentTriangles) {
    Dice dice(31);
    constexpr int kRing = 12;
    std::vector<Vec3> rim;
    for (int i = 0; i < kRing; ++i) {
        const double angle = 0.5236 * i;
        rim.emplace_back(std::cos(angle) + dice.between(-0.1, 0.1), dice.between(-0.2, 0.2),
                         std::sin(angle) + dice.between(-0.1, 0.1));
    }
    const Vec3 hub(0.05, 0.1, -0.03);
    for (int i = 0; i < support::repeats(20000); ++i) {
        const int spoke = dice.below(kRing);
        const Vec3 aim = hub + dice.between(0.0, 0.95) * (rim[static_cast<std::size_t>(spoke)] - hub);
        const Vec3 from = aim + Vec3(0, 1, 0) + dice.in_cube(0.3);
        const Ray ray{from, from + dice.between(1.5, 3.0) * (aim - from)};
        int hits = 0;
        for (std::size_t k = 0; k < kRing; ++k) {
            hits += hit(ray, Triangle{hub, rim[k], rim[(k + 1) % kRing]}) ? 1 : 0;
        }
        ASSERT_GE(hits, 1) << i;
    }
}

TEST(RayOnSolid, AgreesWithThePlainFormula) {
    Dice dice(32);
    int hits = 0;
    const int rays = support::repeats(8000);
    for (int i = 0; i < rays; ++i) {
        const Shape solid = support::random_solid(dice);
        const Ray ray{dice.in_cube(2.0), dice.in_cube(dice.chance(0.5) ? 0.5 : 2.0)};
        const Line line{ray.from, ray.to};
        const auto ours = hit_any(ray, solid);
        const auto plain = support::first_intersection(line, solid);
        if (ours && plain) {
            ASSERT_NEAR(*ours, *plain, 1e-7) << i;
            ++hits;
        } else if (ours || plain) {
            const double graze = support::signed_distance(solid, line.at(ours ? *ours : *plain));
            ASSERT_NEAR(graze, 0.0, 1e-9) << i << ": the two may differ only for grazing rays";
        }
    }
    EXPECT_GT(hits, rays / 10);
}

TEST(RayOnSolid, HitsImmediatelyFromInside) {
    const Ray ray{{0.01, 0.02, 0.01}, {9, 0, 0}};
    EXPECT_EQ(hit(ray, Box{}), 0.0);
    EXPECT_EQ(hit(ray, Sphere{}), 0.0);
    EXPECT_EQ(hit(ray, Capsule{}), 0.0);
    EXPECT_EQ(hit(ray, Wheel{}), 0.0);
}

TEST(RayOnSolid, IsExactAlongAxesAndFaces) {
    EXPECT_EQ(hit({{-2, 0, 0}, {2, 0, 0}}, Box{{1, 1, 1}}), 0.25);
    EXPECT_EQ(hit({{-2, 1, 0}, {2, 1, 0}}, Box{{1, 1, 1}}), 0.25) << "within a face";
    EXPECT_EQ(hit({{-2, 1.001, 0}, {2, 1.001, 0}}, Box{{1, 1, 1}}), std::nullopt);
    EXPECT_EQ(hit({{0, -4, 0}, {0, 4, 0}}, Capsule{0.5, 1.5}), 0.25);
    EXPECT_EQ(hit({{-2, 0, 0}, {2, 0, 0}}, Capsule{1.0, 1.5}), 0.25);
    EXPECT_EQ(hit({{-2, 0, 0}, {2, 0, 0}}, Wheel{0.5, 1.0}), 0.25) << "along the axle";
    EXPECT_EQ(hit({{0, 0, -2}, {0, 0, 2}}, Wheel{1.0, 0.1}), 0.25) << "onto the tread";
    EXPECT_EQ(hit({{0, 0, -2}, {0, 0, -1.1}}, Wheel{1.0, 0.1}), std::nullopt) << "too short";
    EXPECT_EQ(hit({{0, 0, 0}, {0, 0, 0}}, Sphere{1.0}), 0.0) << "a ray of no length, inside";
    EXPECT_EQ(hit({{0, 0, 3}, {0, 0, 3}}, Sphere{1.0}), std::nullopt) << "a ray of no length, outside";
}

}  // namespace
}  // namespace campuswalk::collision
