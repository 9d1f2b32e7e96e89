// How `campuswalk-bench draw` reports times, tested on made-up ones.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "collision/mesh/mesh_query.h"
#include "tests/support/temporary_folder.h"
#include "tools/campuswalk_bench/draw/draw_peers.h"
#include "tools/campuswalk_bench/draw/draw_report.h"
#include "tools/campuswalk_bench/draw/drawn_campus.h"

namespace campuswalk::tools::bench {
namespace {

DrawTimes times_of(const std::string& engine, const std::string& look, double ms) {
    return {engine, look, {{0, ms}, {1, 3.0 * ms}, {0, 2.0 * ms}, {1, 2.0 * ms}}, {}};
}

TEST(DrawTimes, AreTheMeanTheMedianAndTheLeastOfEachView) {
    const DrawTimes times{"a", "fxaa", {{0, 10.0}, {1, 40.0}, {0, 30.0}, {1, 20.0}, {1, 50.0}}, {}};
    EXPECT_DOUBLE_EQ(mean_ms(times), 30.0);
    EXPECT_DOUBLE_EQ(median_ms(times), 30.0);
    EXPECT_DOUBLE_EQ(least_ms(times), 15.0);
    EXPECT_DOUBLE_EQ(median_ms(times_of("a", "fxaa", 10.0)), 20.0);
}

TEST(DrawPeers, FramesAreReadLineByLine) {
    const auto looks =
        parse_times("three.js",
                    "# three.js 187\nframe fxaa 0 12.5\nframe msaa4 0 50\nframe fxaa 1 13\nframe\n"
                    "frame fxaa x 3\nother fxaa 1 2\n");
    ASSERT_EQ(looks.size(), 2U);
    EXPECT_EQ(looks[0].engine, "three.js");
    EXPECT_EQ(looks[0].look, "fxaa");
    ASSERT_EQ(looks[0].images.size(), 2U);
    EXPECT_EQ(looks[0].images[1].view, 1U);
    EXPECT_DOUBLE_EQ(looks[0].images[1].ms, 13.0);
    EXPECT_DOUBLE_EQ(looks[1].images.at(0).ms, 50.0);
    EXPECT_THROW(parse_times("three.js", "nothing\n"), std::runtime_error);
}

DrawnCampus made_up_campus(std::size_t triangles, double ms, std::size_t heap_bytes) {
    return {
        "hills",
        triangles,
        {times_of("campuswalk", "no-aa", 0.5 * ms), times_of("campuswalk", "shadows+fxaa", ms),
         times_of("campuswalk", "shadows+msaa4", 3.0 * ms), times_of("three.js", "shadows+fxaa", 3.0 * ms),
         times_of("vtk", "no-aa", ms), times_of("processes", "shadows+fxaa", 0.75 * ms)},
        15.0,
        heap_bytes};
}

const Verdict& verdict(const std::vector<Verdict>& all, const std::string& what, const std::string& unit) {
    for (const Verdict& each : all) {
        if (each.what.starts_with(what) && each.unit == unit) {
            return each;
        }
    }
    throw std::out_of_range(what);
}

TEST(DrawVerdicts, CompareTimesWithTargets) {
    const auto all =
        draw_verdicts({made_up_campus(500000, 24.0, 100000000), made_up_campus(2000000, 50.0, 500000000)});
    EXPECT_DOUBLE_EQ(*verdict(all, "an image, shadows+fxaa, hills of 500000", " ms").value, 48.0);
    EXPECT_TRUE(verdict(all, "an image, shadows+fxaa, hills of 500000", " ms").holds);
    EXPECT_FALSE(verdict(all, "an image, shadows+msaa4, hills of 500000", " ms").holds) << "144 of 110";
    EXPECT_FALSE(verdict(all, "an image, shadows+fxaa, hills of 2000000", " ms").holds) << "100 of 85";
    EXPECT_DOUBLE_EQ(*verdict(all, "shadows+fxaa, hills of 500000", "x as long in three.js").value, 3.0);
    EXPECT_TRUE(verdict(all, "shadows+fxaa, hills of 500000", "x as long in three.js").holds);
    const std::string by_processes = "shadows+fxaa, hills of 500000 triangles, by processes";
    EXPECT_DOUBLE_EQ(*verdict(all, "an image, " + by_processes, " ms").value, 36.0);
    EXPECT_DOUBLE_EQ(*verdict(all, by_processes, "x as long in three.js").value, 4.0);
    EXPECT_FALSE(verdict(all, "no-aa, hills of 500000", "x as long in VTK").holds)
        << "twice, not three times";
    EXPECT_FALSE(verdict(all, "msaa4, hills of 500000", "x as long in VTK").value.has_value())
        << "not measured";
    EXPECT_NEAR(*verdict(all, "memory per triangle", " bytes").value, 266.67, 0.01);
    EXPECT_FALSE(verdict(all, "memory per triangle", " bytes").holds);
    EXPECT_FALSE(
        verdict(draw_verdicts({made_up_campus(500000, 24.0, 1)}), "memory", " bytes").value.has_value());
}

TEST(DrawCsv, HasALinePerCampusEngineAndLook) {
    const support::TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "new" / "draw.csv";
    DrawnCampus campus = made_up_campus(500000, 24.0, 1);
    campus.looks.pop_back();
    campus.looks.erase(campus.looks.begin() + 1, campus.looks.begin() + 4);
    campus.looks[0].cpu_ms = 20.5;
    write_draw_csv({campus}, file);
    std::ifstream in(file);
    std::stringstream text;
    text << in.rdbuf();
    EXPECT_EQ(text.str(),
              "campus,triangles,engine,look,ms_median,ms_mean,ms_least,ms_cpu,times_ours\n"
              "hills,500000,campuswalk,no-aa,24.00,24.00,18.00,20.50,1.000\n"
              "hills,500000,vtk,no-aa,48.00,48.00,36.00,,2.000\n");
}

void expect_whole(const collision::TriangleMesh& of, std::span<const CampusRun> runs, double lot) {
    const scene::Model model = drawn_campus(of, runs, lot);
    EXPECT_EQ(scene::count_triangles(model), of.triangles.size());
    const scene::Bounds box = scene::world_bounds(model);
    scene::Bounds expected;
    for (const Eigen::Vector3f& position : of.positions) {
        expected.extend(position.cast<double>());
    }
    EXPECT_EQ(box.min, expected.min);
    EXPECT_EQ(box.max, expected.max);
    EXPECT_EQ(model.textures.size() + 1, model.materials.size());
    for (const scene::Mesh& mesh : model.meshes) {
        ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
        ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
        EXPECT_LT(mesh.positions.size(), 3 * mesh.triangles.size()) << mesh.name << " shares no vertices";
        for (const Eigen::Vector3f& normal : mesh.normals) {
            ASSERT_NEAR(normal.norm(), 1.0, 1e-4) << mesh.name;
        }
    }
}

TEST(DrawnCampus, HasAllTrianglesOfTheCampus) {
    const WalkableCampus hills = walkable_campus(1);
    expect_whole(hills.mesh, hills.runs, kWalkableLot);
    const GeneratedCampus houses = generated_campus(1);
    expect_whole(houses.mesh, houses.runs, kGeneratedLot);
}

TEST(DrawnCampus, ViewsOverHillsAreAtEyeHeight) {
    const auto views = views_over_hills(walkable_campus(1));
    ASSERT_EQ(views.size(), 3U);
    for (const DrawnView& view : views) {
        EXPECT_LT(std::abs(view.eye.y()), 8.0);
        EXPECT_GT((view.target - view.eye).norm(), 1.0);
    }
    EXPECT_EQ(views_over_hills(walkable_campus(3)).size(), 24U);
}

TEST(DrawnCampus, ViewsAmongHousesCrossTheCampusOnTheGround) {
    for (const int lots : {2, 3}) {
        const GeneratedCampus campus = generated_campus(lots);
        const collision::MeshCollider mesh(campus.mesh);
        const double half = 0.5 * lots * kGeneratedLot;
        const auto views = views_among_houses(campus, lots);
        ASSERT_EQ(views.size(), 24U);
        for (const DrawnView& view : views) {
            EXPECT_LT(view.eye.cwiseAbs().maxCoeff(), half);
            EXPECT_GT((view.target - view.eye).norm(), 1.0);
            const auto below = first_on_ray(mesh, {view.eye, view.eye - Eigen::Vector3d(0, 4, 0)});
            ASSERT_TRUE(below.has_value());
            EXPECT_NEAR(below->fraction * 4.0, 1.68, 1e-3) << "on the ground, not on a bench";
        }
        EXPECT_GT((views.at(11).eye - views.at(0).eye).norm(), 1.4 * half) << "from one side to the other";
        EXPECT_GT((views.at(23).eye - views.at(12).eye).norm(), 1.4 * half);
    }
}

}  // namespace
}  // namespace campuswalk::tools::bench
