#include "scene/campus/campus.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "collision/mesh/mesh_collider.h"
#include "scene/model/node_frame.h"
#include "tests/scene/model_files.h"
#include "tests/support/says.h"

namespace campuswalk::scene {
namespace {

using support::says;
using test::has_code;
using test::text_of;

SourceMark mark_at(int line) {
    return {"demo.campus.yaml", line, 9};
}

class CampusTest : public testing::Test {
protected:
    void SetUp() override {
        Eigen::Matrix4d turned = test::translation(5, 0.25, -3);
        turned.topLeftCorner<3, 3>() = rotation_about_y(0.5);
        test::write_gltf(
            folder_, "campus",
            {{.name = "terrain", .size = {100, 1, 100}, .X_parent_node = test::translation(0, -0.5, 0)},
             {.name = "library", .X_parent_node = test::translation(20, 0, 0)},
             {.name = "library_walls",
              .size = {10, 6, 8},
              .X_parent_node = test::translation(0, 3, 0),
              .parent = 1},
             {.name = "Tree_01", .size = {1, 4, 1}, .X_parent_node = test::translation(-5, 2, 0)},
             {.name = "Tree_02", .size = {1, 4, 1}, .X_parent_node = test::translation(-8, 2, 0)},
             {.name = "Tree_02", .size = {1, 4, 1}, .X_parent_node = test::translation(-9, 2, 0)},
             {.name = "bench", .size = {2, 0.5F, 0.6F}, .X_parent_node = turned}});
        description_.name = "demo";
        description_.mark = mark_at(1);
        description_.scenes = {test::scene_file(folder_, "campus.gltf")};
        description_.layers = {"ground", "trees"};
        Building library;
        library.mark = mark_at(10);
        library.id = "library";
        library.nodes = {{mark_at(11), "library"}};
        description_.buildings = {library};
    }

    ColliderDescription& add(const std::string& id, const ShapeDescription& shape,
                             const std::vector<std::string>& globs = {}) {
        ColliderDescription collider;
        collider.id = id;
        collider.shape = shape;
        collider.modes.solid = true;
        const int line = 20 + static_cast<int>(description_.colliders.size()) * 5;
        collider.mark = mark_at(line);
        for (const std::string& glob : globs) {
            collider.nodes.push_back({mark_at(line + 1), glob});
        }
        description_.colliders.push_back(collider);
        return description_.colliders.back();
    }

    Campus load() {
        return load_campus(description_, std::make_unique<collision::LinearBroadPhase>(), warnings_);
    }
    std::vector<Diagnostic> errors() {
        return test::errors_of([&] { load(); });
    }

    test::TemporaryFolder folder_;
    CampusDescription description_;
    std::vector<Diagnostic> warnings_;
};

TEST_F(CampusTest, ATriggerOfAMeshIsWhatItEncloses) {
    // A room of 4 x 3 x 4 m that faces inward and has no roof, and a sheet.
    folder_.write("room.obj",
                  "o room\nv -2 0 -2\nv 2 0 -2\nv 2 0 2\nv -2 0 2\nv -2 3 -2\nv 2 3 -2\nv 2 3 2\nv -2 3 2\n"
                  "f 1 4 3 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\no sheet\nv 9 0 0\nv 9 0 1\nv 9 1 "
                  "0\nf 9 10 11\n");
    description_.scenes = {test::scene_file(folder_, "room.obj")};
    description_.buildings.clear();
    add("room", MeshShape{}, {"room"}).modes = {.trigger = true};
    const Campus campus = load();
    const auto& mesh = *std::get<std::shared_ptr<const collision::MeshCollider>>(
        campus.world.object(collision::ObjectId{0}).shape);
    EXPECT_FALSE(mesh.closed_parts().empty());
    EXPECT_TRUE(has_code(warnings_, "closed-openings")) << text_of(warnings_);
    // What is solid, too, stays as it is.
    description_.colliders[0].modes.solid = true;
    const Campus solid = load();
    const auto& walls = *std::get<std::shared_ptr<const collision::MeshCollider>>(
        solid.world.object(collision::ObjectId{0}).shape);
    EXPECT_EQ(walls.mesh().triangles.size(), 10U);
    add("sheet", MeshShape{}, {"sheet"}).modes = {.trigger = true};
    EXPECT_THAT(
        text_of(errors()),
        testing::HasSubstr("error no-inside: nobody can be inside of trigger 'sheet': its surface is flat"));
}

TEST_F(CampusTest, MakesOneObjectPerCollider) {
    auto& ground = add("ground", MeshShape{}, {"terrain"});
    ground.layer = "ground";
    ground.modes.ray = true;
    const Campus campus = load();
    ASSERT_EQ(campus.objects.size(), 1U);
    ASSERT_EQ(campus.world.size(), 1U);
    EXPECT_EQ(campus.objects[0].id, "ground");
    EXPECT_EQ(campus.objects[0].mark.line, 20);
    EXPECT_FALSE(campus.objects[0].building);
    const collision::Object& object = campus.world.object(collision::ObjectId{0});
    EXPECT_EQ(object.layer, 1U);
    EXPECT_EQ(object.detection, collision::Detection::solid | collision::Detection::ray);
    const auto& mesh = std::get<std::shared_ptr<const collision::MeshCollider>>(object.shape);
    EXPECT_EQ(mesh->mesh().triangles.size(), 12U);
    EXPECT_LT((campus.world.bounds().min - collision::Vec3(-50, -1, -50)).norm(), 1e-5);
    EXPECT_LT((campus.world.bounds().max - collision::Vec3(50, 0, 50)).norm(), 1e-5);
    EXPECT_TRUE(warnings_.empty()) << text_of(warnings_);
}

TEST_F(CampusTest, MakesAnObjectForEachNode) {
    CapsuleShape trunk;
    trunk.radius = 0.25;
    trunk.height = 3.0;
    add("tree", trunk, {"Tree_*"}).each = true;
    const Campus campus = load();
    ASSERT_EQ(campus.objects.size(), 3U);
    EXPECT_EQ(campus.objects[0].id, "tree/tree-01");
    EXPECT_EQ(campus.objects[1].id, "tree/tree-02");
    EXPECT_EQ(campus.objects[2].id, "tree/tree-02-2");
    const collision::Object& second = campus.world.object(collision::ObjectId{1});
    EXPECT_EQ(second.X_world_shape.translation.x(), -8.0);
    EXPECT_EQ(std::get<collision::Capsule>(second.shape).radius, 0.25);
}

TEST_F(CampusTest, FitsABoxInItsNodesFrame) {
    add("bench", BoxShape{}, {"bench"}).each = true;
    const Campus campus = load();
    const collision::Object& bench = campus.world.object(collision::ObjectId{0});
    const auto& box = std::get<collision::Box>(bench.shape);
    EXPECT_LT((box.half_extents - collision::Vec3(1, 0.25, 0.3)).norm(), 1e-6);
    EXPECT_LT((bench.X_world_shape.translation - collision::Vec3(5, 0.25, -3)).norm(), 1e-6);
    EXPECT_LT((bench.X_world_shape.rotation - rotation_about_y(0.5)).norm(), 1e-6);
}

TEST_F(CampusTest, UsesTheBuildingsNodesForShapesThatNeedNodes) {
    auto& walls = add("library/walls", MeshShape{});
    walls.building = "library";
    walls.popup = true;
    BoxShape doorway;
    doorway.center = collision::Vec3(15, 1.2, 0);
    doorway.size = collision::Vec3(2, 2.4, 2);
    auto& door = add("library/door", doorway);
    door.building = "library";
    door.modes = {.solid = false, .trigger = true, .ray = false};
    const Campus campus = load();
    ASSERT_EQ(campus.objects.size(), 2U);
    EXPECT_EQ(campus.objects[0].building, 0U);
    EXPECT_TRUE(campus.objects[0].popup);
    EXPECT_LT((campus.world.bounds(collision::ObjectId{0}).max - collision::Vec3(25, 6, 4)).norm(), 1e-5);
    // A door that is given by numbers alone is placed in the world frame.
    const collision::Object& placed = campus.world.object(collision::ObjectId{1});
    EXPECT_EQ(placed.X_world_shape.translation, collision::Vec3(15, 1.2, 0));
    EXPECT_EQ(placed.detection, collision::Detection::trigger);
}

TEST_F(CampusTest, SearchesAllScenesForNodes) {
    folder_.write("more.obj", test::obj_box("Tree_09", {30, 0, 0}, {31, 4, 1}));
    description_.scenes.push_back(test::scene_file(folder_, "more.obj"));
    add("tree", CapsuleShape{}, {"Tree_0[19]"}).each = true;
    const Campus campus = load();
    ASSERT_EQ(campus.objects.size(), 2U);
    EXPECT_EQ(campus.objects[1].id, "tree/tree-09");
    EXPECT_NEAR(campus.world.object(collision::ObjectId{1}).X_world_shape.translation.x(), 30.5, 1e-6);
}

TEST_F(CampusTest, ExcludesNodesThatMatchExcept) {
    const auto triangles_of = [](const Campus& campus, std::size_t object) {
        const auto& shape =
            campus.world.object(collision::ObjectId{static_cast<std::uint32_t>(object)}).shape;
        return std::get<std::shared_ptr<const collision::MeshCollider>>(shape)->mesh().triangles.size();
    };
    add("all", MeshShape{}, {"*"}).except = {{mark_at(30), "library"}, {mark_at(31), "bench"}};
    add("inner", MeshShape{}, {"library"}).except = {{mark_at(32), "Tree_*"}};
    ColliderDescription& each = add("tree", MeshShape{}, {"Tree_*"});
    each.each = true;
    each.except = {{mark_at(33), "Tree_02"}};
    const Campus campus = load();
    ASSERT_EQ(campus.objects.size(), 3U);
    EXPECT_EQ(triangles_of(campus, 0), 4U * 12U);  // the terrain and three trees
    EXPECT_EQ(triangles_of(campus, 1), 12U);
    EXPECT_EQ(campus.objects[2].id, "tree/tree-01");
    EXPECT_EQ(triangles_of(campus, 2), 12U);
}

TEST_F(CampusTest, ExcludesNodesBelowIncludedOnes) {
    add("hull", BoxShape{}, {"library"}).except = {{mark_at(30), "library_walls"}};
    EXPECT_TRUE(has_code(errors(), "empty-mesh"));
}

TEST_F(CampusTest, ReportsExceptionsThatLeaveNothing) {
    add("none", MeshShape{}, {"library_walls"}).except = {{mark_at(30), "library"}};
    add("wrong", MeshShape{}, {"library"}).except = {{mark_at(31), "libary"}};
    add("numbers", SphereShape{Eigen::Vector3d(1, 2, 3), 1.0}).except = {{mark_at(32), "library"}};
    std::vector<std::string> lines;
    for (const Diagnostic& error : errors()) {
        lines.push_back(to_string(error));
    }
    EXPECT_THAT(lines,
                testing::ElementsAre(says("demo.campus.yaml:30:9: error empty-mesh", {"'except'", "'none'"}),
                                     says("demo.campus.yaml:31:9: error no-node", {"'libary'", "'library'"}),
                                     says("demo.campus.yaml:32:9: error missing-nodes", {"'numbers'"})));
}

TEST_F(CampusTest, NumbersLayersFromOne) {
    add("ground", MeshShape{}, {"terrain"});
    const Campus campus = load();
    EXPECT_EQ(campus.layer_index("ground"), 1U);
    EXPECT_EQ(campus.layer_index("trees"), 2U);
    EXPECT_EQ(campus.layer_index(""), 0U);
    EXPECT_EQ(campus.layer_index("nowhere"), 0U);
    EXPECT_EQ(campus.world.object(collision::ObjectId{0}).layer, 0U);
    for (int i = 0; i < 30; ++i) {
        description_.layers.push_back("extra-" + std::to_string(i));
    }
    EXPECT_TRUE(has_code(errors(), "too-many-layers"));
}

TEST_F(CampusTest, ReportsEveryGlobThatMatchesNothing) {
    add("ground", MeshShape{}, {"terain"});
    add("walls", MeshShape{}, {"library_*", "chapel_*"});
    description_.buildings[0].nodes[0].pattern = "lib";
    const auto found = errors();
    ASSERT_EQ(found.size(), 3U) << text_of(found);
    for (const Diagnostic& error : found) {
        EXPECT_EQ(error.code.text(), "no-node");
    }
    EXPECT_EQ(found[0].mark.line, 11);
    EXPECT_EQ(found[1].mark.line, 21);
    EXPECT_NE(found[1].message.find("terrain"), std::string::npos) << found[1].message;
    EXPECT_EQ(found[2].mark.line, 26);
    EXPECT_NE(found[2].message.find("chapel_*"), std::string::npos) << found[2].message;
}

TEST_F(CampusTest, ReportsCollidersWithoutTriangles) {
    test::write_gltf(folder_, "campus", {{.name = "terrain", .size = {1, 1, 1}}, {.name = "marker"}});
    description_.buildings.clear();
    add("ghost", MeshShape{}, {"marker"});
    add("nothing", MeshShape{});
    const auto found = errors();
    ASSERT_EQ(found.size(), 2U) << text_of(found);
    EXPECT_EQ(found[0].code.text(), "empty-mesh");
    EXPECT_EQ(found[0].mark.line, 20);
    EXPECT_EQ(found[1].code.text(), "missing-nodes");
}

TEST_F(CampusTest, ReportsEqualIds) {
    add("tree", CapsuleShape{}, {"Tree_*"}).each = true;
    add("tree/tree-02", MeshShape{}, {"terrain"});
    const auto found = errors();
    ASSERT_EQ(found.size(), 1U) << text_of(found);
    EXPECT_EQ(found[0].code.text(), "duplicate-id");
    EXPECT_EQ(found[0].mark.line, 25);
}

TEST_F(CampusTest, ReportsTheMistakesOfAllScenesTogether) {
    folder_.write("empty.obj", "v 0 0 0\n");
    description_.scenes.push_back(test::scene_file(folder_, "gone.glb"));
    description_.scenes.push_back(test::scene_file(folder_, "empty.obj"));
    const auto found = errors();
    EXPECT_TRUE(has_code(found, "missing-file")) << text_of(found);
    EXPECT_TRUE(has_code(found, "empty-mesh")) << text_of(found);
}

TEST_F(CampusTest, WarnsAboutZeroAreaTriangles) {
    folder_.write("sliver.obj", "o sliver\nv 0 0 0\nv 1 0 0\nv 0 0 -1\nv 2 0 0\nf 1 2 3\nf 1 2 4\n");
    description_.scenes.push_back(test::scene_file(folder_, "sliver.obj"));
    add("sliver", MeshShape{}, {"sliver"});
    load();
    EXPECT_TRUE(has_code(warnings_, "zero-area")) << text_of(warnings_);
}

/// Each model has 1 GB, which is the same memory for all of them.
TEST_F(CampusTest, RefusesModelsThatTakeTooMuchMemoryTogether) {
    constexpr int kSide = 1 << 14;
    const std::shared_ptr<const std::uint8_t[]> pixels(new std::uint8_t[std::size_t{4} * kSide * kSide]);
    Model model;
    model.textures = {{.name = "large",
                       .width = kSide,
                       .height = kSide,
                       .rgba = {{pixels.get(), std::size_t{4} * kSide * kSide}, pixels}}};
    description_.buildings.clear();
    std::atomic<int> imported = 0;
    const auto load = [&](std::size_t scenes, std::size_t at_once) {
        imported = 0;
        description_.scenes.resize(scenes, description_.scenes.front());
        load_campus(
            description_, std::make_unique<collision::LinearBroadPhase>(), warnings_,
            [&](const auto&...) {
                ++imported;
                ImportedModel result;
                result.model = model;
                return result;
            },
            nullptr, at_once);
    };
    load(8, 1);
    EXPECT_EQ(imported, 8);
    for (const std::size_t at_once : {std::size_t{1}, std::size_t{4}}) {
        const std::vector<Diagnostic> errors = test::errors_of([&] { load(100, at_once); });
        EXPECT_THAT(text_of(errors), says("demo.campus.yaml:1:9: error too-large-models", {"8 GB"}));
        EXPECT_LE(imported, 8 + static_cast<int>(at_once));
    }
}

}  // namespace
}  // namespace campuswalk::scene
