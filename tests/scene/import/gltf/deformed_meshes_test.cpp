// Skins, morph targets and hidden nodes: where a mesh is in the pose that the file describes, beside
// glTF 2.0's formulas.

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "scene/import/import_model.h"
#include "tests/scene/import/gltf/gltf_text.h"
#include "tests/scene/import/gltf/packed_meshes.h"
#include "tests/scene/model_files.h"

namespace campuswalk::scene {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;
using test::GltfText;
using test::Json;

const std::array<Vector3d, 3> kTriangle = {Vector3d(0, 0, 0), Vector3d(0, 0, 1), Vector3d(1, 0, 0)};

std::vector<float> column_major(const Affine3d& X) {
    const Eigen::Matrix4f m = X.matrix().cast<float>();
    return {m.data(), m.data() + 16};
}

/// A file with a node "leaf" that draws a skinned triangle.
class SkinnedText {
public:
    /// Four joints and weights a vertex.
    explicit SkinnedText(const std::vector<std::uint8_t>& numbers = std::vector<std::uint8_t>(12, 0),
                         const std::vector<float>& weights = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}) {
        attributes["POSITION"] = text.add_triangle_positions();
        add_set(0, numbers, weights);
    }

    void add_set(int number, const std::vector<std::uint8_t>& numbers, const std::vector<float>& weights) {
        const std::string n = std::to_string(number);
        attributes["JOINTS_" + n] = text.add_accessor(text.add_view(numbers), 5121, 3, "VEC4");
        attributes["WEIGHTS_" + n] = text.add_floats(weights, "VEC4");
    }

    void add_joint(const Affine3d& X_world_joint, const Affine3d& X_joint_bound) {
        joints.push_back(text.add_node({{"matrix", column_major(X_world_joint)}}));
        const std::vector<float> inverse = column_major(X_joint_bound);
        inverse_bind.insert(inverse_bind.end(), inverse.begin(), inverse.end());
    }

    /// The node's other properties, such as its own transform. Returns its number.
    std::size_t add_leaf(Json node = Json::object()) {
        node["name"] = "leaf";
        node["mesh"] = text.add_mesh({{"attributes", attributes}});
        node["skin"] = 0;
        text.json["skins"] = {{{"joints", joints}}};
        if (!inverse_bind.empty()) {
            const std::size_t view = text.add_view(inverse_bind);
            text.json["skins"][0]["inverseBindMatrices"] =
                text.add_accessor(view, 5126, inverse_bind.size() / 16, "MAT4");
        }
        return text.add_node(std::move(node));
    }

    GltfText text;
    Json attributes = Json::object();
    std::vector<std::size_t> joints;
    std::vector<float> inverse_bind;
};

class DeformedMeshesTest : public testing::Test {
protected:
    Model import(const GltfText& text) {
        text.write_glb(folder_, "x.glb");
        ImportedModel imported = import_model(test::scene_file(folder_, "x.glb"), EmptyModel::accept);
        warnings_ = test::text_of(imported.warnings);
        return std::move(imported.model);
    }
    std::string refusal(const GltfText& text) {
        return test::text_of(test::errors_of([&] { import(text); }));
    }
    /// The world positions of a node's only mesh, in the order of its first triangle.
    static std::vector<Vector3d> triangle_of(const Model& model, const std::string& name) {
        const auto node = std::ranges::find(model.nodes, name, &Node::name);
        std::vector<Vector3d> result;
        if (node != model.nodes.end() && node->meshes.size() == 1) {
            const Mesh& mesh = model.meshes[index_of(node->meshes[0])];
            for (const std::uint32_t vertex : mesh.triangles[0]) {
                result.push_back(
                    (node->X_world_node * mesh.positions[vertex].cast<double>().homogeneous()).head<3>());
            }
        }
        return result;
    }
    static void expect_near(const std::vector<Vector3d>& found, const std::vector<Vector3d>& expected) {
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_LT((found[i] - expected[i]).norm(), 1e-5) << i << ": " << found[i].transpose();
        }
    }

    test::TemporaryFolder folder_;
    std::string warnings_;
};

Affine3d pose(double x, double y, double z, double turn_deg) {
    return Eigen::Translation3d(x, y, z) *
           Eigen::AngleAxisd(turn_deg * M_PI / 180.0, Vector3d(1, 2, 2).normalized());
}

std::vector<Vector3d> moved(const Affine3d& X) {
    return {X * kTriangle[0], X * kTriangle[1], X * kTriangle[2]};
}

TEST_F(DeformedMeshesTest, JointsPlaceASkinnedMeshWhateverItsNode) {
    const Affine3d X_world_joint = pose(1, 2, 3, 40);
    const Affine3d X_joint_bound = pose(-2, 0, 1, 25);
    for (const Json& own : {Json::object(), Json{{"translation", {5, 6, 7}}, {"scale", {2, 3, 4}}},
                            Json{{"scale", {0, 0, 0}}}}) {
        SkinnedText skinned;
        skinned.add_joint(X_world_joint, X_joint_bound);
        const std::size_t leaf = skinned.add_leaf(own);
        expect_near(triangle_of(import(skinned.text), "leaf"), moved(X_world_joint * X_joint_bound));
        EXPECT_EQ(warnings_, "");
        // A parent that is moved changes nothing, either.
        skinned.text.json["nodes"].push_back(
            {{"name", "arm"}, {"translation", {9, 9, 9}}, {"children", {leaf}}});
        skinned.text.json["scenes"][0]["nodes"] = {0, 2};
        expect_near(triangle_of(import(skinned.text), "leaf"), moved(X_world_joint * X_joint_bound));
    }
}

TEST_F(DeformedMeshesTest, AFileOfAnotherUnitAndPlaceIsSkinnedThere) {
    SkinnedText skinned;
    skinned.add_joint(pose(100, 0, 0, 40), pose(-2, 0, 1, 25));
    skinned.add_leaf({{"translation", {5, 6, 7}}});
    skinned.text.write_glb(folder_, "x.glb");
    SceneFile file = test::scene_file(folder_, "x.glb");
    file.scale = 0.01;
    file.position = {300'000, 10, 5'000'000};
    const Model model = import_model(file).model;
    const Affine3d X_world_file = Eigen::Translation3d(file.position) * Eigen::Scaling(0.01);
    expect_near(triangle_of(model, "leaf"), moved(X_world_file * pose(100, 0, 0, 40) * pose(-2, 0, 1, 25)));
}

TEST_F(DeformedMeshesTest, JointsAreBlendedByWeightsThatNeedNotAddUpToOne) {
    const std::array<Affine3d, 3> bound = {pose(1, 0, 0, 10), pose(0, 2, 0, -50), pose(0, 0, 3, 120)};
    // The last vertex has no weight at all: it follows the first joint that it names.
    SkinnedText skinned({0, 1, 2, 0, 1, 2, 0, 0, 2, 1, 0, 0},
                        {0.25F, 0.5F, 0.25F, 0, 1, 3, 0, 0, 0, 0, 0, 0});
    for (const Affine3d& X : bound) {
        skinned.add_joint(X, Affine3d::Identity());
    }
    skinned.add_leaf();
    const auto blended = [&](double a, double b, double c, const Vector3d& p) {
        return Vector3d(a * (bound[0] * p) + b * (bound[1] * p) + c * (bound[2] * p));
    };
    expect_near(triangle_of(import(skinned.text), "leaf"),
                {blended(0.25, 0.5, 0.25, kTriangle[0]), blended(0, 0.25, 0.75, kTriangle[1]),
                 bound[2] * kTriangle[2]});
}

TEST_F(DeformedMeshesTest, MoreThanFourJointsAVertexAreRead) {
    const std::vector<float> halves = {0.5F, 0, 0, 0, 0.5F, 0, 0, 0, 0.5F, 0, 0, 0};
    SkinnedText skinned(std::vector<std::uint8_t>(12, 0), halves);
    skinned.add_set(1, std::vector<std::uint8_t>(12, 1), halves);
    skinned.add_joint(pose(2, 0, 0, 0), Affine3d::Identity());
    skinned.add_joint(pose(0, 4, 0, 0), Affine3d::Identity());
    skinned.add_leaf();
    expect_near(triangle_of(import(skinned.text), "leaf"), moved(pose(1, 2, 0, 0)));
}

TEST_F(DeformedMeshesTest, AJointThatMirrorsKeepsTheOutside) {
    const Affine3d X_world_joint = pose(0, 0, 0, 0) * Eigen::Scaling(-1.0, 1.0, 1.0);
    SkinnedText skinned;
    skinned.add_joint(X_world_joint, Affine3d::Identity());
    skinned.add_leaf();
    const std::vector<Vector3d> found = triangle_of(import(skinned.text), "leaf");
    ASSERT_EQ(found.size(), 3U);
    EXPECT_GT((found[1] - found[0]).cross(found[2] - found[0]).y(), 0.0);  // up, as before
}

TEST_F(DeformedMeshesTest, AChildOfASkinnedNodeAndAJointThatIsSkinnedStayInTheHierarchy) {
    SkinnedText skinned;
    skinned.add_joint(pose(1, 2, 3, 40), Affine3d::Identity());
    const std::size_t leaf = skinned.add_leaf({{"translation", {5, 0, 0}}});
    skinned.text.json["skins"][0]["joints"] = {leaf};
    skinned.text.json["nodes"].push_back(
        {{"name", "child"}, {"translation", {1, 0, 0}}, {"mesh", skinned.text.add_triangle_mesh()}});
    skinned.text.json["nodes"][leaf]["children"] = {2};
    const Model model = import(skinned.text);
    expect_near(triangle_of(model, "leaf"), moved(pose(5, 0, 0, 0)));
    expect_near(triangle_of(model, "child"), moved(pose(6, 0, 0, 0)));
}

TEST_F(DeformedMeshesTest, NodesThatDrawTheSameShareIt) {
    SkinnedText skinned;
    skinned.add_joint(pose(1, 2, 3, 40), Affine3d::Identity());
    const std::size_t leaf = skinned.add_leaf();
    skinned.text.add_node(skinned.text.json["nodes"][leaf]);
    EXPECT_EQ(import(skinned.text).meshes.size(), 1U);
}

TEST_F(DeformedMeshesTest, DracoPacksJoints) {
    test::GridMesh grid = test::grid_mesh(3);
    for (std::size_t i = 0; i < grid.positions.size() / 3; ++i) {
        grid.joints.insert(grid.joints.end(),
                           {static_cast<std::uint8_t>(grid.positions[3 * i] > 0.75F), 0, 0, 0});
    }
    GltfText text = test::draco_gltf(grid);
    text.json["nodes"][0]["skin"] = 0;
    text.json["skins"] = {{{"joints", {1, 2}}}};
    text.add_node({{"translation", {10, 0, 0}}});
    text.add_node({{"translation", {10, 5, 0}}});
    const Model model = import(text);
    EXPECT_LT((world_bounds(model).min - Vector3d(10, 0, 0)).norm(), 1e-4);
    EXPECT_LT((world_bounds(model).max - Vector3d(11, 5, 1)).norm(), 1e-4);
}

TEST_F(DeformedMeshesTest, BadSkinsAreRefused) {
    const auto refused = [this](const auto& spoil) {
        SkinnedText skinned({0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0});
        skinned.add_joint(pose(1, 2, 3, 40), Affine3d::Identity());
        skinned.add_joint(pose(1, 2, 3, 40), Affine3d::Identity());
        skinned.add_leaf();
        spoil(skinned.text.json);
        return refusal(skinned.text);
    };
    const auto expect = [](const std::string& message, const char* part) {
        EXPECT_NE(message.find(part), std::string::npos) << message;
    };
    EXPECT_EQ(refused([](Json&) {}), "");
    expect(refused([](Json& json) { json["skins"][0]["joints"] = {0}; }),
           "a joint that its skin does not have");
    expect(refused([](Json& json) { json["skins"][0]["joints"] = Json::array(); }), "skins/0 has no joints");
    expect(refused([](Json& json) {
               json["skins"][0]["joints"] = {0, 77};
           }),
           "a joint that the scene does not place");
    expect(refused([](Json& json) {
               json["scenes"][0]["nodes"] = {1, 2};
           }),
           "a joint that the scene does not place");
    expect(refused([](Json& json) { json["nodes"][2]["skin"] = 7; }), "skins");
    expect(refused([](Json& json) { json["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0"); }),
           "no JOINTS_0 or WEIGHTS_0");
    expect(refused([](Json& json) {
               const auto& attributes = json["meshes"][0]["primitives"][0]["attributes"];
               json["accessors"][attributes["JOINTS_0"].get<std::size_t>()]["count"] = 0;
           }),
           "3 positions, 0 of JOINTS and 3 of WEIGHTS");
    expect(refused([](Json& json) {
               const std::size_t matrices = json["skins"][0]["inverseBindMatrices"].get<std::size_t>();
               json["accessors"][matrices]["count"] = 1;
           }),
           "2 joints and 1 inverse bind matrices");
    expect(
        refused([](Json& json) {
            json["nodes"][2]["extensions"] = {{"EXT_mesh_gpu_instancing", {{"attributes", Json::object()}}}};
        }),
        "both a skin and instances");
}

/// A node "leaf" whose mesh has two morph targets: one moves all by +2 x, the other the last vertex by +3 y.
GltfText morphed_text() {
    GltfText text;
    const std::size_t all = text.add_floats({2, 0, 0, 2, 0, 0, 2, 0, 0}, "VEC3");
    const std::size_t last = text.add_accessor(0, 5126, 3, "VEC3");
    text.json["accessors"][last].erase("bufferView");
    text.json["accessors"][last]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", text.add_view(std::vector<std::uint8_t>{2})}, {"componentType", 5121}}},
        {"values", {{"bufferView", text.add_view(std::vector<float>{0, 3, 0})}}}};
    const Json targets = Json::array({{{"POSITION", all}}, {{"POSITION", last}}});
    text.add_node({{"name", "leaf"},
                   {"mesh", text.add_mesh({{"attributes", {{"POSITION", text.add_triangle_positions()}}},
                                           {"targets", targets}})}});
    return text;
}

TEST_F(DeformedMeshesTest, MorphTargetsHaveTheWeightsOfTheNodeOrElseOfTheMesh) {
    GltfText text = morphed_text();
    expect_near(triangle_of(import(text), "leaf"), moved(Affine3d::Identity()));
    text.json["meshes"][0]["weights"] = {0.5, 1};
    expect_near(triangle_of(import(text), "leaf"), {{1, 0, 0}, {1, 0, 1}, {2, 3, 0}});
    EXPECT_EQ(warnings_, "");
    text.json["nodes"][0]["weights"] = {0, 2};
    expect_near(triangle_of(import(text), "leaf"), {{0, 0, 0}, {0, 0, 1}, {1, 6, 0}});
    text.json["nodes"][0]["weights"] = {0, 0};
    expect_near(triangle_of(import(text), "leaf"), moved(Affine3d::Identity()));
}

TEST_F(DeformedMeshesTest, OneMeshIsMorphedDifferentlyInTwoNodesAndSkinnedAfterwards) {
    GltfText text = morphed_text();
    text.add_node({{"name", "other"}, {"mesh", 0}, {"weights", {1}}});
    const Model model = import(text);
    expect_near(triangle_of(model, "leaf"), moved(Affine3d::Identity()));
    expect_near(triangle_of(model, "other"), moved(pose(2, 0, 0, 0)));

    SkinnedText skinned;
    skinned.add_joint(pose(0, 0, 0, 0) * Eigen::Scaling(3.0), Affine3d::Identity());
    skinned.add_leaf({{"weights", {1}}});
    const std::size_t all = skinned.text.add_floats({2, 0, 0, 2, 0, 0, 2, 0, 0}, "VEC3");
    skinned.text.json["meshes"][0]["primitives"][0]["targets"] = Json::array({{{"POSITION", all}}});
    expect_near(triangle_of(import(skinned.text), "leaf"), {{6, 0, 0}, {6, 0, 3}, {9, 0, 0}});
}

TEST_F(DeformedMeshesTest, ATargetOfAnotherLengthIsRefused) {
    GltfText text = morphed_text();
    text.json["meshes"][0]["weights"] = {1, 0};
    text.json["accessors"][0]["count"] = 2;
    EXPECT_NE(refusal(text).find("3 positions and 2 of a target's POSITION"), std::string::npos)
        << refusal(text);
}

TEST_F(DeformedMeshesTest, HiddenNodesAndAllBelowThemDrawNothing) {
    GltfText text;
    const auto visible = [](bool is) { return Json{{"KHR_node_visibility", {{"visible", is}}}}; };
    const std::size_t mesh = text.add_triangle_mesh();
    text.add_node({{"name", "shown"}, {"mesh", mesh}, {"extensions", visible(true)}});
    const std::size_t hidden = text.add_node(
        {{"name", "hidden"}, {"mesh", text.add_triangle_mesh()}, {"extensions", visible(false)}});
    text.json["nodes"].push_back({{"name", "below"}, {"mesh", mesh}, {"extensions", visible(true)}});
    text.json["nodes"][hidden]["children"] = {text.json["nodes"].size() - 1};
    text.json["extensionsUsed"] = {"KHR_node_visibility"};
    text.json["extensionsRequired"] = {"KHR_node_visibility"};
    for (const bool with_scene :
         {true, false}) {  // without one, what no node draws would be placed at the origin
        if (!with_scene) {
            text.json.erase("scene");
        }
        const Model model = import(text);
        EXPECT_EQ(count_triangles(model), 1U);
        EXPECT_EQ(std::ranges::count(model.nodes, "below", &Node::name), 1);
        EXPECT_NE(warnings_.find("hidden-nodes"), std::string::npos) << warnings_;
        EXPECT_EQ(warnings_.find("unplaced-mesh"), std::string::npos) << warnings_;
    }
}

}  // namespace
}  // namespace campuswalk::scene
