#include "tools/campuswalk_bench/procedural/generated_campus.h"

#include <gtest/gtest.h>

#include "collision/mesh/mesh_query.h"
#include "tools/campuswalk_bench/procedural/campus_parts.h"
#include "tools/campuswalk_bench/procedural/split_mix.h"

namespace campuswalk::tools::bench {
namespace {

using collision::Vec3;

TEST(GeneratedCampus, EightLotsAreHalfAMillionTriangles) {
    const GeneratedCampus campus = generated_campus(8);
    EXPECT_NEAR(static_cast<double>(campus.mesh.triangles.size()), 500e3, 10e3);
    for (const auto& p : campus.mesh.positions) {
        ASSERT_LT(std::abs(p.x()), 260.0F);
        ASSERT_LT(std::abs(p.y()), 40.0F);
        ASSERT_LT(std::abs(p.z()), 260.0F);
    }
}

TEST(GeneratedCampus, FeetAreOutdoorsOnTheGround) {
    const GeneratedCampus campus = generated_campus(2);
    const collision::MeshCollider mesh(campus.mesh);
    std::size_t under_trees = 0;
    EXPECT_GT(campus.feet.size(), 1000U);
    for (const Vec3& foot : campus.feet) {
        ASSERT_LT(closest_point(mesh, foot).distance, 1e-5);
        under_trees += any_on_ray(mesh, {foot + Vec3(0, 0.01, 0), foot + Vec3(0, 100, 0)}) ? 1U : 0U;
    }
    EXPECT_LT(under_trees, campus.feet.size() / 4) << "the others are under the sky";
    EXPECT_GT(under_trees, 0U);
}

TEST(GeneratedCampus, RunsHaveTheKindsOfTriangles) {
    const GeneratedCampus campus = generated_campus(1);
    const auto& runs = campus.runs;
    ASSERT_EQ(runs.size(), 5U);
    EXPECT_EQ(runs.at(0).part, CampusPart::terrain);
    EXPECT_EQ(runs.at(1).part, CampusPart::building);
    EXPECT_EQ(runs.at(1).first_triangle, 2U * 24U * 24U) << "after the terrain";
    EXPECT_EQ(runs.at(2).part, CampusPart::tree);
    EXPECT_EQ(runs.at(3).part, CampusPart::bench);
    EXPECT_EQ(runs.at(4).part, CampusPart::lamp);
    double highest_bench = 0.0;
    for (std::size_t t = runs.at(3).first_triangle; t < runs.at(4).first_triangle; ++t) {
        const Vec3 vertex = campus.mesh.positions[campus.mesh.triangles[t][0]].cast<double>();
        highest_bench = std::max(highest_bench, vertex.y() - rolling_ground(vertex.x(), vertex.z()));
    }
    EXPECT_LT(highest_bench, 1.5);
    EXPECT_GT(highest_bench, 0.4);
}

TEST(GeneratedCampus, RaysHitNearAndFarThingsAndTheSky) {
    const GeneratedCampus campus = generated_campus(2);
    const collision::MeshCollider mesh(campus.mesh);
    SplitMix random(7);
    int far = 0;
    int near = 0;
    constexpr int kRays = 1000;
    for (int i = 0; i < kRays; ++i) {
        const auto foot =
            static_cast<std::size_t>(random.between(0.0, static_cast<double>(campus.feet.size())));
        const Vec3 eye = campus.feet[foot] + Vec3(0, 1.6, 0);
        const auto hit = first_on_ray(mesh, {eye, eye + 200.0 * random.direction()});
        near += hit && hit->fraction <= 0.05 ? 1 : 0;
        far += hit && hit->fraction > 0.05 ? 1 : 0;
    }
    EXPECT_GT(near, kRays / 4) << "the ground, at least";
    EXPECT_GT(far, kRays / 10) << "houses and trees";
    EXPECT_LT(near + far, kRays * 9 / 10) << "and the sky";
}

TEST(SplitMix, AgreesWithThePublishedGenerator) {
    // The first number of the published generator with seed 0 is 0xE220A8397B1DCDAF.
    SplitMix random(0);
    EXPECT_EQ(random.between(0.0, 1.0), 0x1p-53 * static_cast<double>(0xE220A8397B1DCDAFU >> 11U));
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < 1000; ++i) {
        const Vec3 d = random.direction();
        ASSERT_NEAR(d.norm(), 1.0, 1e-12);
        sum += d;
    }
    EXPECT_LT(sum.norm() / 1000.0, 0.1);
}

}  // namespace
}  // namespace campuswalk::tools::bench
