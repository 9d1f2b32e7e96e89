#include "collision/mesh/mesh_query.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/collision/mesh/loop_queries.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/plain_solids.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;
using support::Line;
using support::repeats;
using support::vertices_of;

Segment random_segment(Dice& dice) {
    const Vec3 a = dice.in_cube(4.0);
    return {a, dice.chance(0.2) ? a : Vec3(a + dice.in_cube(dice.chance(0.5) ? 1.0 : 4.0))};
}

Segment segment_around(const TriangleMesh& mesh, Dice& dice) {
    const Vec3 a = point_around(mesh, dice, 2.0);
    return {a, dice.chance(0.2) ? a : Vec3(a + dice.in_cube(2.0))};
}

TEST(TrianglesNear, AgreeWithALoopOverAllTriangles) {
    Dice dice(40);
    std::size_t found = 0;
    for (int m = 0; m < repeats(80); ++m) {
        const bool hard = m % 2 == 1;
        const BothTrees both(hard ? hard_mesh(dice) : mesh_of_some_kind(dice));
        for (int i = 0; i < 40; ++i) {
            const Segment segment = hard ? segment_around(both.mesh(), dice) : random_segment(dice);
            const double radius = dice.chance(0.1) ? 0.0 : dice.between(0.0, 1.5);
            const std::vector<std::uint32_t> expected = loop_near(both.mesh(), segment, radius);
            for (const MeshCollider* mesh : both.each()) {
                std::vector<std::uint32_t> near{12345};
                QueryStatistics counters;
                triangles_near(*mesh, segment, radius, near, &counters);
                ASSERT_EQ(near, expected) << m << ' ' << i;
                ASSERT_GE(counters.primitive_tests, near.size());
            }
            found += expected.size();
        }
    }
    EXPECT_GT(found, static_cast<std::size_t>(repeats(2000)));
}

TEST(TrianglesNear, AgreeWithThePlainFormula) {
    Dice dice(41);
    for (int m = 0; m < repeats(40); ++m) {
        const BothTrees both(mesh_of_some_kind(dice));
        for (int i = 0; i < 20; ++i) {
            const Segment segment = random_segment(dice);
            const double radius = dice.between(0.0, 1.5);
            std::vector<std::uint32_t> near;
            triangles_near(*both.each()[static_cast<std::size_t>(i % 2)], segment, radius, near);
            for (std::uint32_t t = 0; t < both.mesh().triangles.size(); ++t) {
                const double distance =
                    support::distance(Line{segment.a, segment.b}, vertices_of(vertices(both.mesh(), t)));
                if (std::abs(distance - radius) > 1e-9) {
                    ASSERT_EQ(std::binary_search(near.begin(), near.end(), t), distance < radius) << t;
                }
            }
        }
    }
}

TEST(TrianglesNear, IncludeExactTouching) {
    TriangleMesh floor;
    support::add_floor(floor, 4.0, 0.0, 1.0);
    const BothTrees both(floor);
    for (const MeshCollider* mesh : both.each()) {
        std::vector<std::uint32_t> near;
        triangles_near(*mesh, {{0.3, 0.5, 0.6}, {0.3, 2.0, 0.6}}, 0.5, near);
        EXPECT_EQ(near, loop_near(floor, {{0.3, 0.5, 0.6}, {0.3, 2.0, 0.6}}, 0.5));
        EXPECT_EQ(near.size(), 1U);
        triangles_near(*mesh, {{0.3, 0.5, 0.6}, {0.3, 2.0, 0.6}}, 0.4999, near);
        EXPECT_TRUE(near.empty());
    }
}

/// Checks all three ray queries; returns their statistics.
QueryStatistics expect_hits(const MeshCollider& mesh, const Ray& ray, const std::vector<MeshHit>& expected,
                            SimdTarget simd_target) {
    QueryStatistics counters;
    std::vector<MeshHit> all{{0.5, 12345}};
    all_on_ray(mesh, ray, all, &counters, simd_target);
    EXPECT_EQ(all, expected);
    EXPECT_EQ(first_on_ray(mesh, ray, &counters, simd_target),
              expected.empty() ? std::nullopt : std::optional(expected.front()));
    EXPECT_EQ(any_on_ray(mesh, ray, &counters, simd_target), !expected.empty());
    EXPECT_EQ(counters.transform_updates, 3U);
    return counters;
}

/// With both trees and every SIMD target; returns how many triangles the ray hits.
std::size_t expect_hits_of_loop(const BothTrees& both, const Ray& ray) {
    const std::vector<MeshHit> expected = loop_all_on_ray(both.mesh(), ray);
    {
        SCOPED_TRACE("hybrid");
        expect_hits(both.hybrid, ray, expected, SimdTarget::sse42);
    }
    std::optional<QueryStatistics> work;
    for (const SimdTarget simd_target : supported_simd_targets()) {
        SCOPED_TRACE(static_cast<int>(simd_target));
        const QueryStatistics counters = expect_hits(both.bvh8, ray, expected, simd_target);
        work = work.value_or(counters);
        EXPECT_EQ(counters.volume_tests, work->volume_tests);
        EXPECT_EQ(counters.primitive_tests, work->primitive_tests);
    }
    return expected.size();
}

TEST(RayHits, AgreeWithALoopOverAllTriangles) {
    Dice dice(42);
    std::size_t hits = 0;
    for (int m = 0; m < repeats(100); ++m) {
        const BothTrees both(mesh_of_some_kind(dice));
        for (int i = 0; i < 60; ++i) {
            SCOPED_TRACE(m * 100 + i);
            hits += expect_hits_of_loop(both, {dice.in_cube(6.0), dice.in_cube(6.0)});
        }
    }
    EXPECT_GT(hits, static_cast<std::size_t>(repeats(400)));
}

TEST(RayHits, OfHardMeshesAgreeWithTheLoop) {
    Dice dice(46);
    std::size_t hits = 0;
    for (int m = 0; m < repeats(80); ++m) {
        const BothTrees both(hard_mesh(dice));
        for (int i = 0; i < 40; ++i) {
            SCOPED_TRACE(m * 100 + i);
            const Vec3 from = point_around(both.mesh(), dice, 5.0);
            const Vec3 through = point_around(both.mesh(), dice, dice.chance(0.5) ? 0.0 : 0.5);
            hits += expect_hits_of_loop(both, {from, from + dice.between(0.5, 3.0) * (through - from)});
        }
    }
    EXPECT_GT(hits, static_cast<std::size_t>(repeats(1500)));
}

/// Rays along the lattice's lines pass through vertices, along edges and within planes; nothing is rounded,
/// because all products are integers.
TEST(RayHits, AlongALatticeAgreeWithTheLoop) {
    Dice dice(47);
    std::size_t hits = 0;
    for (int m = 0; m < repeats(60); ++m) {
        const Vec3 at = m % 2 == 0 ? Vec3(0, 0, 0) : Vec3(450000, 60, -448000);
        const BothTrees both(support::lattice_soup(dice, 120, at));
        for (int i = 0; i < 30; ++i) {
            SCOPED_TRACE(m * 100 + i);
            Ray ray;
            ray.from = at + Vec3(dice.below(7), dice.below(7), dice.below(7));
            ray.to = ray.from;
            ray.from[i % 3] -= 4.0;
            ray.to[i % 3] += 4.0;
            hits += expect_hits_of_loop(both, dice.chance(0.5) ? ray : Ray{ray.to, ray.from});
        }
    }
    EXPECT_GT(hits, static_cast<std::size_t>(repeats(1000)));
}

TEST(RayHits, AgreeWithThePlainFormula) {
    Dice dice(43);
    for (int m = 0; m < repeats(60); ++m) {
        const BothTrees both(support::random_mesh(dice, 150, 3.0));
        for (int i = 0; i < 40; ++i) {
            const Ray ray{dice.in_cube(6.0), dice.in_cube(6.0)};
            double plain = 2.0;
            for (std::size_t t = 0; t < both.mesh().triangles.size(); ++t) {
                const auto f = support::first_intersection(Line{ray.from, ray.to},
                                                           vertices_of(vertices(both.mesh(), t)));
                plain = std::min(plain, f.value_or(2.0));
            }
            const auto ours = first_on_ray(*both.each()[static_cast<std::size_t>(i % 2)], ray);
            ASSERT_NEAR(ours ? ours->fraction : 2.0, plain, 1e-9) << m << ' ' << i;
        }
    }
}

TEST(RayHits, InTheSamePlaceAreOrderedByIndex) {
    TriangleMesh stack;
    for (int i = 0; i < 30; ++i) {
        support::add_triangle(stack, {-1, 0, -1}, {0, 0, 2}, {1, 0, -1});
    }
    const BothTrees both(stack);
    for (const MeshCollider* mesh : both.each()) {
        const auto found = first_on_ray(*mesh, {{0, 1, 0}, {0, -1, 0}});
        EXPECT_EQ(found, (MeshHit{0.5, 0}));
        std::vector<MeshHit> all;
        all_on_ray(*mesh, {{0, 1, 0}, {0, -1, 0}}, all);
        ASSERT_EQ(all.size(), 30U);
        for (std::uint32_t t = 0; t < 30; ++t) {
            EXPECT_EQ(all[t], (MeshHit{0.5, t}));
        }
    }
}

TEST(RayHits, AreNoneForARayOfNoLength) {
    TriangleMesh floor;
    support::add_floor(floor, 4.0, 0.0, 1.0);
    EXPECT_EQ(expect_hits_of_loop(BothTrees(floor), {{0.3, 0, 0.6}, {0.3, 0, 0.6}}), 0U);
}

TEST(RayHits, FromFarAwayIncludeASmallMesh) {
    TriangleMesh small;
    support::add_box(small, {-0.01, -0.01, -0.01}, {0.01, 0.01, 0.01});
    const BothTrees both(small);
    Dice dice(48);
    for (int i = 0; i < 200; ++i) {
        const Vec3 from = dice.in_cube(1e7);
        EXPECT_GE(expect_hits_of_loop(both, {from, Vec3(-from)}), 1U) << i;
    }
}

/// From 1e-25 to 1e10 metres, with rays of all lengths.
TEST(RayHits, AtAnyScaleAgreeWithTheLoop) {
    Dice dice(54);
    std::size_t hits = 0;
    for (int m = 0; m < repeats(60); ++m) {
        TriangleMesh mesh = mesh_of_some_kind(dice);
        const double scale = std::array{1e-25, 1e-9, 1e-3, 1e3, 1e10}[static_cast<std::size_t>(m % 5)];
        for (Eigen::Vector3f& p : mesh.positions) {
            p *= static_cast<float>(scale);
        }
        const BothTrees both(mesh);
        for (int i = 0; i < 40; ++i) {
            SCOPED_TRACE(m * 100 + i);
            const Vec3 from = scale * dice.in_cube(6.0);
            const Vec3 along = point_around(both.mesh(), dice, 0.1 * scale) - from;
            const double length = std::array{0.9, 1.1, 1e3, 1e9, 1e30}[static_cast<std::size_t>(i % 5)];
            hits += expect_hits_of_loop(both, {from, from + length * along});
        }
    }
    EXPECT_GT(hits, static_cast<std::size_t>(repeats(1000)));
}

/// Longer than float32 can represent.
TEST(RayHits, OfVeryLongRaysAgreeWithTheLoop) {
    Dice dice(55);
    std::size_t hits = 0;
    const BothTrees both(support::random_mesh(dice, 200, 4.0));
    for (int i = 0; i < repeats(200); ++i) {
        SCOPED_TRACE(i);
        const Vec3 from = dice.in_cube(6.0);
        const Vec3 along = point_around(both.mesh(), dice, 0.1) - from;
        hits += expect_hits_of_loop(both, {from, from + 1e60 * along});
        hits += expect_hits_of_loop(both, {from - 1e60 * along, from});
    }
    EXPECT_GT(hits, static_cast<std::size_t>(repeats(100)));
}

/// Many nodes, many of them with their own coordinate frame, and few triangles to test per ray.
TEST(RayHits, OfASphereAgreeWithTheLoop) {
    Dice dice(56);
    TriangleMesh ball = support::ball(30);
    const Mat3 turn = support::random_pose(dice, 0.0).rotation;
    for (Eigen::Vector3f& p : ball.positions) {
        p = (turn * p.cast<double>()).cast<float>();
    }
    const BothTrees both(ball);
    const auto& nodes = both.bvh8.bvh8().nodes;
    EXPECT_GT(std::count_if(nodes.begin(), nodes.end(), [](const Bvh8Node& n) { return n.rotated; }), 10);
    std::size_t hits = 0;
    QueryStatistics work;
    for (int i = 0; i < repeats(300); ++i) {
        SCOPED_TRACE(i);
        const Ray ray{dice.in_cube(1.5), dice.in_cube(1.5)};
        hits += expect_hits_of_loop(both, ray);
        std::vector<MeshHit> all;
        all_on_ray(both.bvh8, ray, all, &work);
    }
    EXPECT_GT(hits, static_cast<std::size_t>(repeats(200)));
    EXPECT_LE(work.primitive_tests, 2 * hits) << "the float32 test rejects nearly all misses";
}

TEST(ClosestPoint, AgreesWithALoopOverAllTriangles) {
    Dice dice(49);
    for (int m = 0; m < repeats(120); ++m) {
        const BothTrees both(m % 2 == 1 ? hard_mesh(dice) : mesh_of_some_kind(dice));
        for (int i = 0; i < 40; ++i) {
            const Vec3 point = point_around(both.mesh(), dice, dice.chance(0.2) ? 100.0 : 2.0);
            const MeshPoint expected = loop_closest_point(both.mesh(), point);
            for (const MeshCollider* mesh : both.each()) {
                const MeshPoint ours = closest_point(*mesh, point);
                ASSERT_EQ(ours.distance, expected.distance) << m << ' ' << i;
                ASSERT_EQ(ours.triangle, expected.triangle) << m << ' ' << i;
                ASSERT_EQ(ours.point, expected.point) << m << ' ' << i;
            }
        }
    }
}

TEST(ClosestPoint, OnALatticeIsOnTheTriangleWithTheLowestIndex) {
    Dice dice(51);
    for (int m = 0; m < repeats(60); ++m) {
        const BothTrees both(support::lattice_soup(dice, 120, Vec3::Zero()));
        for (int i = 0; i < 30; ++i) {
            const Vec3 point(dice.below(9) - 1, dice.below(9) - 1, dice.below(9) - 1);
            const MeshPoint expected = loop_closest_point(both.mesh(), point);
            for (const MeshCollider* mesh : both.each()) {
                ASSERT_EQ(closest_point(*mesh, point).triangle, expected.triangle);
            }
        }
    }
}

TEST(TrianglesInBox, AgreeWithALoopOverAllTriangles) {
    Dice dice(53);
    std::size_t found = 0;
    for (int m = 0; m < repeats(80); ++m) {
        const BothTrees both(m % 2 == 1 ? hard_mesh(dice) : mesh_of_some_kind(dice));
        for (int i = 0; i < 30; ++i) {
            const Box box{Vec3(dice.between(0.0, 2.0), dice.between(0.0, 1.0), dice.between(0.0, 1.0))};
            Pose X = support::random_pose(dice, 0.0);
            X.translation = point_around(both.mesh(), dice, 2.0);
            const std::vector<std::uint32_t> expected = loop_in_box(both.mesh(), box, X);
            for (const MeshCollider* mesh : both.each()) {
                std::vector<std::uint32_t> inside{12345};
                triangles_in_box(*mesh, box, X, inside);
                ASSERT_EQ(inside, expected) << m << ' ' << i;
                ASSERT_EQ(any_in_box(*mesh, box, X), !expected.empty()) << m << ' ' << i;
            }
            found += expected.size();
        }
    }
    EXPECT_GT(found, static_cast<std::size_t>(repeats(2000)));
}

TEST(SweepOfAMesh, AgreesWithALoopOverAllTriangles) {
    Dice dice(52);
    int contacts = 0;
    for (int m = 0; m < repeats(80); ++m) {
        const bool hard = m % 2 == 1;
        const BothTrees both(hard ? hard_mesh(dice) : mesh_of_some_kind(dice));
        for (int i = 0; i < 20; ++i) {
            const Segment segment = hard ? segment_around(both.mesh(), dice) : random_segment(dice);
            const Vec3 move = dice.in_cube(4.0);
            const double radius = dice.chance(0.2) ? 0.0 : dice.between(0.0, 0.5);
            const auto expected = loop_sweep(both.mesh(), segment, radius, move);
            for (const MeshCollider* mesh : both.each()) {
                ASSERT_EQ(sweep(*mesh, segment, radius, move), expected) << m << ' ' << i;
            }
            contacts += expected ? 1 : 0;
        }
    }
    EXPECT_GT(contacts, repeats(300));
}

}  // namespace
}  // namespace campuswalk::collision
