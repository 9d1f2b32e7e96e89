#include "scene/campus/place_scene.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "scene/campus/campus.h"
#include "scene/model/node_frame.h"
#include "tests/scene/model_files.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

class PlaceSceneTest : public testing::Test {
protected:
    void SetUp() override {
        test::write_gltf(
            folder_, "bench",
            {{.name = "bench", .X_parent_node = test::translation(0, 1, 0)},
             {.name = "seat", .size = {4, 2, 1}, .X_parent_node = test::translation(1, 0, 0), .parent = 0}});
        file_ = test::scene_file(folder_, "bench.gltf");
    }

    ScenePlacement& place(const Vector3d& position, double yaw, double scale = 1.0,
                          const std::string& name = "") {
        file_.placements.push_back({file_.mark, name, position, rotation_about_y(yaw), scale});
        return file_.placements.back();
    }
    Model placed() {
        Model model = import_model(file_).model;
        place_scene(file_, model);
        return model;
    }

    test::TemporaryFolder folder_;
    SceneFile file_;
};

TEST_F(PlaceSceneTest, KeepsTheHierarchyOfTheOnlyPlacement) {
    place({10, 20, 30}, M_PI / 2, 2.0);
    const Model model = placed();
    ASSERT_EQ(model.nodes.size(), 2U);
    EXPECT_EQ(model.nodes[0].parent, -1);
    // The seat, x -1..3, y 0..2, z ±0.5, twice as large and turned left: +X to -Z.
    EXPECT_LT((world_bounds(model).min - Vector3d(9, 20, 24)).norm(), 1e-12);
    EXPECT_LT((world_bounds(model).max - Vector3d(11, 24, 32)).norm(), 1e-12);
}

TEST_F(PlaceSceneTest, PutsANodeAboveEachOfSeveralPlacements) {
    place({0, 0, 0}, 0.0);
    place({100, 0, 0}, 0.3, 1.5, "at-the-gate");
    place({0, 0, 50}, -2.0);
    const Model model = placed();
    ASSERT_EQ(model.nodes.size(), 9U);
    EXPECT_EQ(model.meshes.size(), 1U);
    const std::array<const char*, 3> names = {"bench#1", "at-the-gate", "bench#3"};
    for (std::size_t i = 0; i < 3; ++i) {
        const ScenePlacement& placement = file_.placements[i];
        const Eigen::Affine3d X =
            Eigen::Translation3d(placement.position) * placement.rotation * Eigen::Scaling(placement.scale);
        EXPECT_EQ(model.nodes[3 * i].name, names.at(i));
        EXPECT_EQ(model.nodes[3 * i].parent, -1);
        EXPECT_EQ(model.nodes[3 * i + 1].parent, static_cast<int>(3 * i));
        EXPECT_EQ(model.nodes[3 * i + 2].parent, static_cast<int>(3 * i + 1));
        EXPECT_EQ(model.nodes[3 * i + 2].name, "seat");
        const Eigen::Matrix4d expected = (X * Eigen::Translation3d(1, 1, 0)).matrix();
        EXPECT_LT((model.nodes[3 * i + 2].X_world_node - expected).norm(), 1e-12);
    }
}

TEST_F(PlaceSceneTest, ComesAfterTheFilesUnitAndAxis) {
    file_.up = UpAxis::z;
    file_.scale = 0.5;
    place({0, 10, 0}, 0.0, 4.0);
    // Z-up: x -1..3, y ±0.5 to the back, z 0 (1 - 1)..2 up, half as large and then four times.
    const Bounds bounds = world_bounds(placed());
    EXPECT_LT((bounds.min - Vector3d(-2, 9, -4)).norm(), 1e-12) << bounds.min.transpose();
    EXPECT_LT((bounds.max - Vector3d(6, 11, 0)).norm(), 1e-12) << bounds.max.transpose();
}

TEST_F(PlaceSceneTest, SelectsPlacementsByName) {
    place({0, 0, 0}, 0.0);
    place({100, 0, 0}, 0.0, 1.0, "at-the-gate");
    CampusDescription description;
    description.scenes = {file_};
    ColliderDescription gate;
    gate.id = "gate";
    gate.shape = MeshShape{};
    gate.modes.solid = true;
    gate.nodes = {{{}, "at-the-gate"}};
    ColliderDescription each = gate;
    each.id = "each";
    each.each = true;
    each.nodes = {{{}, "bench"}};
    description.colliders = {gate, each};
    std::vector<Diagnostic> warnings;
    const Campus campus = load_campus(description, std::make_unique<collision::LinearBroadPhase>(), warnings);
    ASSERT_EQ(campus.objects.size(), 3U);
    EXPECT_EQ(campus.objects[0].id, "gate");
    EXPECT_EQ(campus.objects[1].id, "each/bench");
    EXPECT_EQ(campus.objects[2].id, "each/bench-2");
}

TEST_F(PlaceSceneTest, RefusesMoreNodesThanAModelMayHave) {
    for (int i = 0; i < 333'334; ++i) {
        place({}, 0.0);
    }
    const std::string error = test::text_of(test::errors_of([&] { placed(); }));
    EXPECT_NE(error.find("'bench.gltf', placed 333334 times, has 1000002 nodes; a model may have 1000000"),
              std::string::npos)
        << error;
}

TEST_F(PlaceSceneTest, RefusesNamesThatTakeGigabytesTogether) {
    for (int i = 0; i < 2'000; ++i) {
        place({}, 0.0);
    }
    Model model = import_model(file_).model;
    model.nodes[1].name.assign(1'000'000, 'n');
    const std::string error = test::text_of(test::errors_of([&] { place_scene(file_, model); }));
    EXPECT_NE(error.find("MB of nodes; a model may have 1024"), std::string::npos) << error;
    EXPECT_EQ(model.nodes.size(), 2U);
}

TEST_F(PlaceSceneTest, HashesWhatPlacesAModel) {
    const ContentHash contents = ContentHasher().result();
    EXPECT_EQ(placed_contents(file_, contents), contents);
    place({1, 2, 3}, 0.0);
    const ContentHash once = placed_contents(file_, contents);
    EXPECT_NE(once, contents);
    file_.placements[0].position.x() += 1e-9;
    EXPECT_NE(placed_contents(file_, contents), once);
    file_.placements[0].position.x() = 1;
    EXPECT_EQ(placed_contents(file_, contents), once);
    file_.placements[0].name = "named";
    EXPECT_NE(placed_contents(file_, contents), once);
}

}  // namespace
}  // namespace campuswalk::scene
