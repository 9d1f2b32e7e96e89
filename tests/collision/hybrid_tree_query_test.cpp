#include "collision/hybrid_tree_query.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "collision/closest.h"
#include "collision/obstacle.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/plain_solids.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::corners_of;
using support::Dice;
using support::Line;
using support::repeats;

/// Meshes that trees find easy and hard: scattered, regular, in one place, of one triangle.
TriangleMesh mesh_of_some_kind(Dice& dice) {
    TriangleMesh mesh;
    switch (dice.below(5)) {
        case 0:
            support::add_floor(mesh, 4.0, 0.0, 0.5);
            support::add_stairs(mesh, 0.0, 0.0, 2.0, 0.17, 0.3, 10);
            return mesh;
        case 1:
            return support::random_mesh(dice, 1, 1.0);
        case 2:
            return support::random_mesh(dice, 80, 0.1);
        default:
            return support::random_mesh(dice, 200, 4.0);
    }
}

Segment random_segment(Dice& dice) {
    const Vec3 a = dice.in_cube(4.0);
    return {a, dice.chance(0.2) ? a : Vec3(a + dice.in_cube(dice.chance(0.5) ? 1.0 : 4.0))};
}

/// What triangles_near answers, by a loop with the same test of one triangle: the sets must be the same.
std::vector<std::uint32_t> loop_near(const TriangleMesh& mesh, const Segment& segment, double radius) {
    std::vector<std::uint32_t> near;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (closest(segment, corners(mesh, t)).distance <= radius) {
            near.push_back(t);
        }
    }
    return near;
}

std::optional<MeshRayHit> loop_first_on_ray(const TriangleMesh& mesh, const Ray& ray) {
    std::optional<MeshRayHit> first;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto f = hit(ray, corners(mesh, t));
        if (f && (!first || *f < first->fraction)) {
            first = MeshRayHit{*f, t};
        }
    }
    return first;
}

TEST(TrianglesNear, AreThoseOfTheLoop) {
    Dice dice(40);
    std::size_t found = 0;
    for (int m = 0; m < repeats(60); ++m) {
        const MeshCollider mesh(mesh_of_some_kind(dice));
        for (int i = 0; i < 40; ++i) {
            const Segment segment = random_segment(dice);
            const double radius = dice.chance(0.1) ? 0.0 : dice.between(0.0, 1.5);
            std::vector<std::uint32_t> near{12345};
            QueryCounters counters;
            triangles_near(mesh, segment, radius, near, counters);
            ASSERT_EQ(near, loop_near(mesh.mesh(), segment, radius)) << m << ' ' << i;
            found += near.size();
        }
    }
    EXPECT_GT(found, 1000U);
}

TEST(TrianglesNear, AreThoseThePlainFormulaFinds) {
    Dice dice(41);
    for (int m = 0; m < repeats(40); ++m) {
        const MeshCollider mesh(mesh_of_some_kind(dice));
        for (int i = 0; i < 20; ++i) {
            const Segment segment = random_segment(dice);
            const double radius = dice.between(0.0, 1.5);
            std::vector<std::uint32_t> near;
            QueryCounters counters;
            triangles_near(mesh, segment, radius, near, counters);
            for (std::uint32_t t = 0; t < mesh.mesh().triangles.size(); ++t) {
                const double distance =
                    support::distance(Line{segment.a, segment.b}, corners_of(corners(mesh.mesh(), t)));
                if (std::abs(distance - radius) > 1e-9) {
                    ASSERT_EQ(std::binary_search(near.begin(), near.end(), t), distance < radius) << t;
                }
            }
        }
    }
}

TEST(TrianglesNear, TouchingExactlyCounts) {
    TriangleMesh floor;
    support::add_floor(floor, 4.0, 0.0, 1.0);
    const MeshCollider mesh(floor);
    std::vector<std::uint32_t> near;
    QueryCounters counters;
    triangles_near(mesh, {{0.3, 0.5, 0.6}, {0.3, 2.0, 0.6}}, 0.5, near, counters);
    EXPECT_EQ(near, loop_near(floor, {{0.3, 0.5, 0.6}, {0.3, 2.0, 0.6}}, 0.5));
    EXPECT_EQ(near.size(), 1U);
    triangles_near(mesh, {{0.3, 0.5, 0.6}, {0.3, 2.0, 0.6}}, 0.4999, near, counters);
    EXPECT_TRUE(near.empty());
}

TEST(FirstOnRay, IsThatOfTheLoop) {
    Dice dice(42);
    int hits = 0;
    for (int m = 0; m < repeats(100); ++m) {
        const MeshCollider mesh(mesh_of_some_kind(dice));
        for (int i = 0; i < 60; ++i) {
            const Ray ray{dice.in_cube(6.0), dice.in_cube(6.0)};
            QueryCounters counters;
            const auto ours = first_on_ray(mesh, ray, counters);
            const auto loop = loop_first_on_ray(mesh.mesh(), ray);
            ASSERT_EQ(ours.has_value(), loop.has_value()) << m << ' ' << i;
            if (ours) {
                ASSERT_EQ(ours->fraction, loop->fraction) << m << ' ' << i;
                ASSERT_EQ(ours->triangle, loop->triangle) << m << ' ' << i;
                ++hits;
            }
        }
    }
    EXPECT_GT(hits, repeats(200));
}

TEST(FirstOnRay, IsWhereThePlainFormulaSays) {
    Dice dice(43);
    for (int m = 0; m < repeats(60); ++m) {
        const MeshCollider mesh(support::random_mesh(dice, 150, 3.0));
        for (int i = 0; i < 40; ++i) {
            const Ray ray{dice.in_cube(6.0), dice.in_cube(6.0)};
            double plain = 2.0;
            for (std::size_t t = 0; t < mesh.mesh().triangles.size(); ++t) {
                const auto f =
                    support::first_meeting(Line{ray.from, ray.to}, corners_of(corners(mesh.mesh(), t)));
                plain = std::min(plain, f.value_or(2.0));
            }
            QueryCounters counters;
            const auto ours = first_on_ray(mesh, ray, counters);
            ASSERT_NEAR(ours ? ours->fraction : 2.0, plain, 1e-9) << m << ' ' << i;
        }
    }
}

TEST(FirstOnRay, OfSeveralAtOnePlaceTheLowestIndexIsHit) {
    TriangleMesh stack;
    for (int i = 0; i < 30; ++i) {
        support::add_triangle(stack, {-1, 0, -1}, {0, 0, 2}, {1, 0, -1});
    }
    QueryCounters counters;
    const auto found = first_on_ray(MeshCollider(stack), {{0, 1, 0}, {0, -1, 0}}, counters);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->triangle, 0U);
    EXPECT_EQ(found->fraction, 0.5);
}

/// A placed mesh as the mover sees it, through tree and pose, and the plain distance to all of it.
class PlacedMesh {
public:
    explicit PlacedMesh(Dice& dice) : X_(support::random_pose(dice, 50.0)) {
        TriangleMesh mesh = mesh_of_some_kind(dice);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const Triangle c = corners(mesh, t);
            triangles_.push_back({X_ * c.a, X_ * c.b, X_ * c.c});
        }
        support::add_object(world_, std::move(mesh), Detection::solid, X_);
    }

    const World& world() const { return world_; }
    const Pose& pose() const { return X_; }
    const std::vector<support::Corners>& triangles() const { return triangles_; }

private:
    Pose X_;
    World world_{std::make_unique<LinearBroadPhase>()};
    std::vector<support::Corners> triangles_;
};

TEST(ClosestOfAPlacedMesh, IsThatOfTheLoop) {
    Dice dice(44);
    int near = 0;
    for (int m = 0; m < repeats(80); ++m) {
        const PlacedMesh mesh(dice);
        for (int i = 0; i < 20; ++i) {
            const Segment local = random_segment(dice);
            const Segment segment{mesh.pose() * local.a, mesh.pose() * local.b};
            constexpr double kReach = 1.5;
            double plain = kReach;
            for (const support::Corners& t : mesh.triangles()) {
                plain = std::min(plain, support::distance(Line{segment.a, segment.b}, t));
            }
            std::vector<Obstacle> obstacles;
            QueryCounters counters;
            gather_obstacles(mesh.world(), {}, segment, kReach, obstacles, counters);
            double ours = kReach;
            for (const Obstacle& o : obstacles) {
                ours = std::min(ours, closest(segment, o).distance);
            }
            ASSERT_NEAR(ours, plain, 1e-9) << m << ' ' << i;
            near += ours < kReach ? 1 : 0;
        }
    }
    EXPECT_GT(near, repeats(300));
}

/// The first contact of a moving capsule with all triangles, by halving a convex function's interval.
double loop_sweep(const PlacedMesh& mesh, const Segment& segment, double radius, const Vec3& move) {
    double first = 2.0;
    for (const support::Corners& t : mesh.triangles()) {
        if (support::distance(Line{segment.a, segment.b}, t) > radius + move.norm()) {
            continue;  // it can't come that far
        }
        const auto f = support::first_not_above_zero([&](double at) {
            return support::distance(Line{segment.a + at * move, segment.b + at * move}, t) - radius;
        });
        first = std::min(first, f.value_or(2.0));
    }
    return first;
}

TEST(SweepOfAPlacedMesh, IsThatOfTheLoop) {
    Dice dice(45);
    int contacts = 0;
    const int meshes = repeats(60);
    for (int m = 0; m < meshes; ++m) {
        const PlacedMesh mesh(dice);
        for (int i = 0; i < 6; ++i) {
            const Segment local = random_segment(dice);
            const Segment segment{mesh.pose() * local.a, mesh.pose() * local.b};
            const Vec3 move = dice.in_cube(2.0);
            const double radius = dice.between(0.05, 0.4);
            const double plain = loop_sweep(mesh, segment, radius, move);
            if (plain == 0.0) {
                continue;  // in contact from the start: the mover's sweep lets such bodies move away
            }
            std::vector<Obstacle> obstacles;
            QueryCounters counters;
            const Segment middle{segment.a + 0.5 * move, segment.b + 0.5 * move};
            gather_obstacles(mesh.world(), {}, middle, radius + 0.5 * move.norm(), obstacles, counters);
            double ours = 2.0;
            for (const Obstacle& o : obstacles) {
                ours = std::min(ours, sweep(segment, radius, move, o).value_or(2.0));
            }
            ASSERT_LE(ours, plain + 1e-9) << m << ' ' << i << ": never beyond the contact";
            if (ours < plain - 1e-6) {  // a graze: it stopped where the gap is all but closed
                double gap = 1.0;
                for (const support::Corners& t : mesh.triangles()) {
                    const Line moved{segment.a + ours * move, segment.b + ours * move};
                    gap = std::min(gap, support::distance(moved, t) - radius);
                }
                ASSERT_LT(gap, 1e-6) << m << ' ' << i;
            }
            contacts += ours < 1.0 ? 1 : 0;
        }
    }
    EXPECT_GT(contacts, meshes / 2);
}

}  // namespace
}  // namespace campuswalk::collision
