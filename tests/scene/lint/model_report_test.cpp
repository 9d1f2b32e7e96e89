#include "scene/lint/model_report.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "scene/import/import_model.h"
#include "tests/scene/model_files.h"

namespace campuswalk::scene {
namespace {

bool has_lint(const ModelReport& report, const std::string& code) {
    return std::ranges::any_of(report.warnings, [&](const ModelLint& o) { return o.code.text() == code; });
}

std::string all_lints(const ModelReport& report) {
    std::string text;
    for (const ModelLint& lint : report.warnings) {
        text += std::string(lint.code.text()) + ": " + lint.message + "\n";
    }
    return text;
}

class ModelReportTest : public testing::Test {
protected:
    Model import(const std::string& name) {
        return import_model(test::scene_file(folder_, name), EmptyModel::accept).model;
    }
    ModelReport report_of(const std::vector<test::TinyNode>& nodes) {
        test::write_gltf(folder_, "model", nodes);
        return report(import("model.gltf"));
    }

    test::TemporaryFolder folder_;
};

TEST_F(ModelReportTest, CountsNodesMeshesAndTriangles) {
    const ModelReport r = report_of(
        {{.name = "campus"},
         {.name = "hall", .size = {20, 5, 10}, .parent = 0},
         {.name = "roof", .size = {20, 1, 10}, .X_parent_node = test::translation(0, 3, 0), .parent = 1}});
    EXPECT_EQ(r.file, "model.gltf");
    EXPECT_EQ(r.meshes, 2U);
    EXPECT_EQ(r.placements, 2U);
    EXPECT_EQ(r.triangles, 24U);
    EXPECT_EQ(r.bounds.max, Eigen::Vector3d(10, 3.5, 5));
    ASSERT_EQ(r.nodes.size(), 3U);
    EXPECT_EQ(r.nodes[2].depth, 2);
    EXPECT_EQ(r.nodes[1].triangles, 12U);
    EXPECT_EQ(r.nodes[1].bounds.max, Eigen::Vector3d(10, 3.5, 5));  // with its subtree
    EXPECT_TRUE(r.warnings.empty()) << all_lints(r);
}

TEST_F(ModelReportTest, FindsNoLintInAHouseOnALawn) {
    const ModelReport r = report_of({{.name = "campus"},
                                     {.name = "lawn", .size = {60, 0.5, 60}, .parent = 0},
                                     {.name = "hall", .size = {20, 5, 10}, .parent = 0}});
    EXPECT_TRUE(r.warnings.empty()) << all_lints(r);
}

TEST_F(ModelReportTest, FindsAnEmptyModel) {
    EXPECT_TRUE(has_lint(report_of({{.name = "nothing"}}), "no-triangles"));
}

TEST_F(ModelReportTest, FindsModelsFarFromTheOrigin) {
    const ModelReport placed = report_of(
        {{.name = "hall", .size = {20, 5, 10}, .X_parent_node = test::translation(84616, 0, 447750)}});
    EXPECT_TRUE(has_lint(placed, "far-from-origin"));
    EXPECT_FALSE(has_lint(placed, "coarse-position")) << all_lints(placed);  // the node carries the offset
    folder_.write("far.obj", test::obj_box("hall", {84616, 0, 447750}, {84636, 5, 447760}));
    EXPECT_FALSE(
        has_lint(report(import("far.obj")), "coarse-position"));  // see scene/import/source/obj_text.h
    folder_.write("far.stl",
                  "solid hall\nfacet normal 0 1 0\nouter loop\nvertex 84616 0 447750\nvertex 84616 0 447760\n"
                  "vertex 84636 0 447750\nendloop\nendfacet\nendsolid hall\n");
    EXPECT_TRUE(has_lint(report(import("far.stl")), "coarse-position"));
}

TEST_F(ModelReportTest, FindsMirroredUnnamedAndRepeatedNodes) {
    Eigen::Matrix4d mirror = test::translation(5, 0, 0);
    mirror(2, 2) = -1.0;
    const ModelReport r =
        report_of({{.name = "wing", .size = {1, 1, 1}},
                   {.name = "wing", .size = {1, 1, 1}, .X_parent_node = mirror},
                   {.name = "", .size = {1, 1, 1}, .X_parent_node = test::translation(9, 0, 0)}});
    EXPECT_TRUE(has_lint(r, "mirrored-node")) << all_lints(r);
    EXPECT_TRUE(has_lint(r, "unnamed-node")) << all_lints(r);
    EXPECT_TRUE(has_lint(r, "repeated-name")) << all_lints(r);
}

TEST_F(ModelReportTest, CountsDuplicateFaces) {
    const Model twice = [&] {
        folder_.write("twice.obj", test::obj_box("a", {0, 0, 0}, {4, 4, 4}) +
                                       test::obj_box("b", {0, 0, 0}, {4, 4, 4}, 9) +
                                       test::obj_box("c", {9, 0, 0}, {12, 4, 4}, 17));
        return import("twice.obj");
    }();
    const std::vector<DuplicateFaces> duplicates = find_duplicate_faces(twice, world_bounds(twice));
    ASSERT_EQ(duplicates.size(), 1U);
    EXPECT_EQ(twice.nodes[duplicates[0].node].name, "b");
    EXPECT_EQ(duplicates[0].count, 12U);
    EXPECT_EQ(duplicates[0].first.cwiseMax(0.0).cwiseMin(4.0), duplicates[0].first);  // on the box
    // Degenerate triangles don't count.
    folder_.write("point.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\nf 1 2 3\n");
    const Model point = import("point.obj");
    EXPECT_TRUE(find_duplicate_faces(point, world_bounds(point)).empty());
    EXPECT_NE(all_lints(report(point)).find("odd-scale: "), std::string::npos);
    // Front and back of the same sheet are two faces.
    folder_.write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\nf 3 2 1\nf 2 3 1\n");
    const Model sheet = import("sheet.obj");
    ASSERT_EQ(find_duplicate_faces(sheet, world_bounds(sheet)).size(), 1U);
    EXPECT_EQ(find_duplicate_faces(sheet, world_bounds(sheet))[0].count, 1U);
    EXPECT_TRUE(find_duplicate_faces(sheet, world_bounds(sheet))[0].first.isApprox(
        Eigen::Vector3d(1, 0, 1) / 3.0, 1e-6));
}

TEST_F(ModelReportTest, FindsTheNodeThatStretchesTheBounds) {
    std::string text;
    for (int i = 0; i < 100; ++i) {
        const int row = i / 10;
        const Eigen::Vector3d low(i % 10 * 10.0, 0, row * 10.0);
        text += test::obj_box("house_" + std::to_string(i), low, low + Eigen::Vector3d(5, 4, 5), 1 + 8 * i);
    }
    folder_.write("town.obj", text);
    EXPECT_TRUE(outlier_nodes(import("town.obj")).empty());
    text += "o lake\nv 0 0 0\nv 7800 0 0\nv 0 0 7800\nf 801 802 803\n";
    folder_.write("town.obj", text);
    const Model town = import("town.obj");
    const auto outliers = outlier_nodes(town);
    ASSERT_EQ(outliers.size(), 1U);
    EXPECT_EQ(town.nodes[outliers[0]].name, "lake");
    const ModelReport r = report(town);
    const auto lint =
        std::ranges::find_if(r.warnings, [](const ModelLint& o) { return o.code == "outlier"; });
    ASSERT_NE(lint, r.warnings.end());
    ASSERT_EQ(lint->places.size(), 1U);
    EXPECT_EQ(lint->places[0].node, "lake");
    EXPECT_EQ(lint->places[0].at, Eigen::Vector3d(3900, 0, 3900));
}

TEST_F(ModelReportTest, TakesTheGroundAroundADenseCrowdForNoOutlier) {
    std::string text = test::obj_box("ground", {-60, -1, -60}, {60, 0, 60}) +
                       test::obj_box("hall", {-10, 0, -10}, {10, 6, 10}, 9);
    for (int i = 0; i < 100; ++i) {
        const int row = i / 10;
        const Eigen::Vector3d low(-50.0 + i % 10 * 0.5, 0, 20.0 + row * 0.5);
        text += test::obj_box("chair_" + std::to_string(i), low, low + Eigen::Vector3d(0.4, 0.9, 0.4),
                              17 + 8 * i);
    }
    folder_.write("hall.obj", text);
    EXPECT_TRUE(outlier_nodes(import("hall.obj")).empty());
}

}  // namespace
}  // namespace campuswalk::scene
