#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "collision/world/obstacle.h"
#include "tests/collision/mesh/loop_queries.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/plain_solids.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;
using support::Line;
using support::repeats;

Segment random_segment(Dice& dice) {
    const Vec3 a = dice.in_cube(4.0);
    return {a, dice.chance(0.2) ? a : Vec3(a + dice.in_cube(dice.chance(0.5) ? 1.0 : 4.0))};
}

/// A placed mesh as the mover sees it, through tree and pose, and its triangles for the plain formulas.
class PlacedMesh {
public:
    explicit PlacedMesh(Dice& dice) : X_(support::random_pose(dice, 50.0)) {
        TriangleMesh mesh = mesh_of_some_kind(dice);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const Triangle c = vertices(mesh, t);
            triangles_.push_back({X_ * c.a, X_ * c.b, X_ * c.c});
        }
        support::add_object(world_, std::move(mesh), Detection::solid, X_);
    }

    const World& world() const { return world_; }
    const Pose& pose() const { return X_; }
    const std::vector<support::Vertices>& triangles() const { return triangles_; }

private:
    Pose X_;
    World world_{std::make_unique<LinearBroadPhase>()};
    std::vector<support::Vertices> triangles_;
};

TEST(ClosestOfAPlacedMesh, AgreesWithALoopOverAllTriangles) {
    Dice dice(44);
    int near = 0;
    for (int m = 0; m < repeats(80); ++m) {
        const PlacedMesh mesh(dice);
        for (int i = 0; i < 20; ++i) {
            const Segment local = random_segment(dice);
            const Segment segment{mesh.pose() * local.a, mesh.pose() * local.b};
            constexpr double kReach = 1.5;
            double plain = kReach;
            for (const support::Vertices& t : mesh.triangles()) {
                plain = std::min(plain, support::distance(Line{segment.a, segment.b}, t));
            }
            std::vector<Obstacle> obstacles;
            gather_obstacles(mesh.world(), {}, segment, kReach, obstacles);
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

/// The first contact of a moving capsule with all triangles, by bisection of a convex function.
double plain_sweep(const PlacedMesh& mesh, const Segment& segment, double radius, const Vec3& move) {
    double first = 2.0;
    for (const support::Vertices& t : mesh.triangles()) {
        if (support::distance(Line{segment.a, segment.b}, t) > radius + move.norm()) {
            continue;  // out of reach
        }
        const auto f = support::first_not_above_zero([&](double at) {
            return support::distance(Line{segment.a + at * move, segment.b + at * move}, t) - radius;
        });
        first = std::min(first, f.value_or(2.0));
    }
    return first;
}

TEST(SweepOfAPlacedMesh, AgreesWithALoopOverAllTriangles) {
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
            const double plain = plain_sweep(mesh, segment, radius, move);
            if (plain == 0.0) {
                continue;  // in contact from the start: the mover's sweep lets such bodies move away
            }
            std::vector<Obstacle> obstacles;
            const Segment middle{segment.a + 0.5 * move, segment.b + 0.5 * move};
            gather_obstacles(mesh.world(), {}, middle, radius + 0.5 * move.norm(), obstacles);
            double ours = 2.0;
            for (const Obstacle& o : obstacles) {
                ours = std::min(ours, sweep(segment, radius, move, o).value_or(2.0));
            }
            ASSERT_LE(ours, plain + 1e-9) << m << ' ' << i << ": never beyond the contact";
            if (ours < plain - 1e-6) {  // a grazing contact: it stopped where the gap is almost closed
                double gap = 1.0;
                for (const support::Vertices& t : mesh.triangles()) {
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
