#include "scene/model/model.h"

#include <gtest/gtest.h>

#include "tests/scene/model_files.h"

namespace campuswalk::scene {
namespace {

/// root > library > library_roof, tree > library_sign; each but root with one triangle.
Model small_model() {
    Model model;
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
    mesh.triangles = {{0, 1, 2}};
    model.meshes = {mesh};
    model.nodes.resize(5);
    const char* names[] = {"root", "library", "library_roof", "tree", "library_sign"};
    const int parents[] = {-1, 0, 1, 0, 3};
    for (std::size_t i = 0; i < 5; ++i) {
        model.nodes[i].name = names[i];
        model.nodes[i].parent = parents[i];
        model.nodes[i].X_world_node = test::translation(static_cast<double>(i), 0, 0);
        if (i > 0) {
            model.nodes[i].meshes = {MeshIndex{0}};
        }
    }
    return model;
}

TEST(Model, CountsTrianglesAsDrawn) {
    EXPECT_EQ(count_triangles(small_model()), 4U);
    EXPECT_EQ(count_triangles(Model{}), 0U);
}

TEST(Model, BoundsAreInWorldCoordinates) {
    const Bounds bounds = world_bounds(small_model());
    EXPECT_EQ(bounds.min, Eigen::Vector3d(1, 0, 0));
    EXPECT_EQ(bounds.max, Eigen::Vector3d(5, 2, 0));
    EXPECT_TRUE(world_bounds(Model{}).empty());
}

TEST(Model, MatchingANodeIncludesItsSubtree) {
    using Indices = std::vector<std::size_t>;
    const Model model = small_model();
    EXPECT_EQ(match_nodes(model, "library"), (Indices{1, 2}));
    EXPECT_EQ(match_nodes(model, "library*"), (Indices{1, 2, 4}));
    EXPECT_EQ(match_nodes(model, "tree"), (Indices{3, 4}));
    EXPECT_EQ(match_nodes(model, "root"), (Indices{0, 1, 2, 3, 4}));
    EXPECT_TRUE(match_nodes(model, "chapel").empty());
}

}  // namespace
}  // namespace campuswalk::scene
