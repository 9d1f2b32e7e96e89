// Features that real files use, each in a small file that is written with the same encoders.

#include <cmath>
#include <cstring>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "scene/import/import_model.h"
#include "tests/scene/import/gltf/gltf_text.h"
#include "tests/scene/import/gltf/packed_meshes.h"
#include "tests/scene/model_files.h"

namespace campuswalk::scene {
namespace {

using test::GltfText;
using test::Json;

class GltfSourceTest : public testing::Test {
protected:
    Model import(const std::string& name, EmptyModel if_empty = EmptyModel::refuse) {
        ImportedModel imported = import_model(test::scene_file(folder_, name), if_empty);
        warnings_ = std::move(imported.warnings);
        return std::move(imported.model);
    }
    Model import(const GltfText& text) {
        text.write_glb(folder_, "x.glb");
        return import("x.glb");
    }
    std::string refusal(const GltfText& text) {
        return test::text_of(test::errors_of([&] { import(text); }));
    }
    std::string warnings() const { return test::text_of(warnings_); }

    test::TemporaryFolder folder_;
    std::vector<Diagnostic> warnings_;
};

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

double area_of(const Model& model) {
    double area = 0.0;
    for (const Node& node : model.nodes) {
        for (const MeshIndex index : node.meshes) {
            const Mesh& mesh = model.meshes[index_of(index)];
            for (const auto& t : mesh.triangles) {
                const Eigen::Vector3d a = mesh.positions[t[0]].cast<double>();
                const Eigen::Vector3d b = mesh.positions[t[1]].cast<double>();
                const Eigen::Vector3d c = mesh.positions[t[2]].cast<double>();
                area += 0.5 * (b - a).cross(c - a).norm();
            }
        }
    }
    return area;
}

// ---- packed meshes

TEST_F(GltfSourceTest, DecodesDracoOfAllIndexWidths) {
    for (const std::size_t side : {10U, 100U, 300U}) {  // 100, 10,000 and 90,000 vertices
        const test::GridMesh grid = test::grid_mesh(side);
        const Model model = import(test::draco_gltf(grid));
        EXPECT_EQ(count_triangles(model), grid.indices.size() / 3);
        EXPECT_NEAR(area_of(model), 1.0, 1e-3);
        EXPECT_NEAR(world_bounds(model).max.x(), 1.0, 1e-3);
        EXPECT_EQ(model.nodes[0].name, "packed");
        EXPECT_EQ(warnings(), "");
    }
}

TEST_F(GltfSourceTest, RejectsDamagedDraco) {
    std::vector<std::uint8_t> packed = test::draco_of(test::grid_mesh(10));
    packed.resize(packed.size() / 2);
    GltfText text;
    const std::size_t view = text.add_view(packed);
    const Json packing = {{"bufferView", view}, {"attributes", {{"POSITION", 0}}}};
    text.add_node({{"mesh", text.add_mesh({{"attributes", {{"POSITION", 0}}},
                                           {"extensions", {{"KHR_draco_mesh_compression", packing}}}})}});
    EXPECT_TRUE(contains(refusal(text), "KHR_draco_mesh_compression"));
}

TEST_F(GltfSourceTest, DecodesMeshopt) {
    const test::GridMesh grid = test::grid_mesh(50);
    const Model model = import(test::meshopt_gltf(grid));
    EXPECT_EQ(count_triangles(model), grid.indices.size() / 3);
    EXPECT_NEAR(area_of(model), 1.0, 1e-5);
    EXPECT_EQ(world_bounds(model).max, Eigen::Vector3d(1, 0, 1));
}

TEST_F(GltfSourceTest, RejectsInvalidMeshopt) {
    const GltfText good = test::meshopt_gltf(test::grid_mesh(10));
    const auto refused_with = [&](const char* key, const Json& value) {
        GltfText text = good;
        text.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"][key] = value;
        return refusal(text);
    };
    EXPECT_TRUE(contains(refused_with("byteStride", 0), "byteStride"));
    EXPECT_TRUE(contains(refused_with("byteStride", 13), "byteStride"));
    EXPECT_TRUE(contains(refused_with("count", 1'000'000'000), "count"));
    EXPECT_TRUE(contains(refused_with("mode", "MAGIC"), "MAGIC"));
    EXPECT_TRUE(contains(refused_with("filter", "OCTAHEDRAL"), "OCTAHEDRAL"));
    EXPECT_TRUE(contains(refused_with("byteLength", 1'000'000), "buffers/0"));
}

// ---- arrays

TEST_F(GltfSourceTest, ReadsInterleavedSparseAndQuantizedPositions) {
    GltfText text;
    // Interleaved positions with a stride of 20 bytes; a sparse accessor replaces the last one.
    const std::vector<float> mixed = {0, 0, 0, 9, 9, 0, 0, 1, 9, 9, 5, 5, 5, 9, 9};
    const std::size_t view = text.add_view(mixed);
    text.json["bufferViews"][view]["byteStride"] = 20;
    const std::size_t positions = text.add_accessor(view, 5126, 3, "VEC3");
    const std::size_t which = text.add_view(std::vector<std::uint8_t>{2});
    const std::size_t value = text.add_view(std::vector<float>{1, 0, 0});
    text.json["accessors"][positions]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", which}, {"componentType", 5121}}},
        {"values", {{"bufferView", value}}}};
    text.add_node({{"name", "float"}, {"mesh", text.add_mesh({{"attributes", {{"POSITION", positions}}}})}});
    const std::size_t shorts = text.add_accessor(
        text.add_view(std::vector<std::int16_t>{0, 0, 0, 0, 0, 32767, 32767, 0, -32768}), 5122, 3, "VEC3");
    text.json["accessors"][shorts]["normalized"] = true;
    text.add_node({{"name", "short"}, {"mesh", text.add_mesh({{"attributes", {{"POSITION", shorts}}}})}});
    const Model model = import(text);
    EXPECT_EQ(model.meshes[0].positions[0], Eigen::Vector3f(0, 0, 0));
    EXPECT_EQ(model.meshes[0].positions[1], Eigen::Vector3f(0, 0, 1));
    EXPECT_EQ(model.meshes[0].positions[2], Eigen::Vector3f(1, 0, 0));
    EXPECT_EQ(model.meshes[1].positions[1], Eigen::Vector3f(0, 0, 1));
    EXPECT_EQ(model.meshes[1].positions[2], Eigen::Vector3f(1, 0, -1));
}

TEST_F(GltfSourceTest, StripsAndFansHaveTheSameWinding) {
    GltfText text;
    const std::size_t strip = text.add_floats({0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 2, 0, 0}, "VEC3");
    const std::size_t fan = text.add_floats({0, 0, 0, 0, 0, 1, 1, 0, 1, 1, 0, 0}, "VEC3");
    text.add_node({{"mesh", text.add_mesh({{"attributes", {{"POSITION", strip}}}, {"mode", 5}})}});
    text.add_node({{"mesh", text.add_mesh({{"attributes", {{"POSITION", fan}}}, {"mode", 6}})}});
    const Model model = import(text);
    ASSERT_EQ(count_triangles(model), 5U);
    for (const Mesh& mesh : model.meshes) {
        for (const Eigen::Vector3f& normal : mesh.normals) {
            EXPECT_EQ(normal, Eigen::Vector3f(0, 1, 0));
        }
    }
    EXPECT_NEAR(area_of(model), 1.5 + 1.0, 1e-6);
}

TEST_F(GltfSourceTest, RejectsInvalidAccessors) {
    const auto with_accessor = [&](const Json& change) {
        GltfText text;
        text.add_node({{"mesh", text.add_triangle_mesh()}});
        text.json["accessors"][0].update(change);
        return refusal(text);
    };
    EXPECT_EQ(with_accessor(Json::object()), "");
    EXPECT_TRUE(contains(with_accessor({{"count", 4}}), "accessors/0"));
    EXPECT_TRUE(contains(with_accessor({{"count", 1e15}}), "count"));
    EXPECT_TRUE(contains(with_accessor({{"count", -3}}), "count"));
    EXPECT_TRUE(contains(with_accessor({{"byteOffset", 1e15}}), "accessors/0"));
    EXPECT_TRUE(contains(with_accessor({{"bufferView", 7}}), "bufferViews/7"));
    EXPECT_TRUE(contains(with_accessor({{"type", "MAT4"}}), "type"));
    EXPECT_TRUE(contains(with_accessor({{"componentType", 5124}}), "componentType"));
}

TEST_F(GltfSourceTest, ReadsMissingDataAsZerosWithAWarning) {
    GltfText text;
    text.add_node({{"mesh", text.add_triangle_mesh()}});
    text.json["accessors"][0].erase("bufferView");
    EXPECT_EQ(world_bounds(import(text)).max, Eigen::Vector3d::Zero());
    EXPECT_TRUE(test::has_code(warnings_, "missing-data")) << warnings();
}

// ---- the hierarchy

TEST_F(GltfSourceTest, PlacesInstances) {
    GltfText text;
    const float quarter = std::sqrt(0.5F);
    const Json attributes = {
        {"TRANSLATION", text.add_floats({10, 0, 0, 20, 0, 0, 30, 0, 0}, "VEC3")},
        {"ROTATION", text.add_floats({0, 0, 0, 1, 0, quarter, 0, quarter, 0, 0, 0, 1}, "VEC4")},
        {"SCALE", text.add_floats({1, 1, 1, 1, 1, 1, 2, 2, 2}, "VEC3")}};
    text.add_node({{"name", "lamp"},
                   {"mesh", text.add_triangle_mesh()},
                   {"translation", {0, 5, 0}},
                   {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", attributes}}}}}});
    text.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    const Model model = import(text);
    EXPECT_EQ(count_triangles(model), 3U);
    EXPECT_EQ(match_nodes(model, "lamp").size(), 4U);
    ASSERT_EQ(match_nodes(model, "lamp#3").size(), 1U);
    const Node& third = model.nodes[match_nodes(model, "lamp#3")[0]];
    EXPECT_EQ(Eigen::Vector4d(third.X_world_node * Eigen::Vector4d(1, 0, 0, 1)),
              Eigen::Vector4d(32, 5, 0, 1));
    const Node& second = model.nodes[match_nodes(model, "lamp#2")[0]];
    EXPECT_LT((second.X_world_node * Eigen::Vector4d(1, 0, 0, 1) - Eigen::Vector4d(20, 5, -1, 1)).norm(),
              1e-6);
    EXPECT_EQ(warnings(), "");
}

TEST_F(GltfSourceTest, RefusesInstancesOfUnknownNumberOrPlace) {
    for (const bool mismatched : {false, true}) {
        GltfText text;
        Json attributes = {{"_ID", text.add_floats({1, 2}, "SCALAR")}};
        if (mismatched) {
            attributes = {{"TRANSLATION", text.add_floats({1, 0, 0, 2, 0, 0, 3, 0, 0}, "VEC3")},
                          {"SCALE", text.add_floats({1, 1, 1, 2, 2, 2}, "VEC3")}};
        }
        text.add_node({{"mesh", text.add_triangle_mesh()},
                       {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", attributes}}}}}});
        const auto errors = test::errors_of([&] { import(text); });
        ASSERT_EQ(errors.size(), 1U);
        EXPECT_TRUE(
            contains(errors[0].message, mismatched ? "different numbers of instances" : "no TRANSLATION"))
            << errors[0].message;
    }
}

TEST_F(GltfSourceTest, ReadsTheDefaultSceneAndWarnsAboutOthers) {
    GltfText text;
    const std::size_t mesh = text.add_triangle_mesh();
    text.add_node({{"name", "here"}, {"mesh", mesh}});
    text.json["nodes"].push_back({{"name", "there"}, {"mesh", mesh}});
    text.json["scenes"].push_back({{"nodes", {1}}});
    EXPECT_EQ(count_triangles(import(text)), 1U);
    EXPECT_TRUE(contains(warnings(), "2 scenes")) << warnings();
    text.json["scene"] = 1;
    EXPECT_EQ(match_nodes(import(text), "there").size(), 1U);
    text.json.erase("scene");  // then the first
    const Model first = import(text);
    EXPECT_EQ(count_triangles(first), 1U);
    EXPECT_EQ(match_nodes(first, "here").size(), 1U);
    EXPECT_TRUE(contains(warnings(), "2 scenes")) << warnings();
}

TEST_F(GltfSourceTest, PlacesUnusedMeshesOnlyWithoutADefaultScene) {
    GltfText text;
    text.add_node({{"mesh", text.add_triangle_mesh()}});
    text.add_triangle_mesh();
    EXPECT_EQ(count_triangles(import(text)), 1U);
    EXPECT_TRUE(contains(warnings(), "warning unplaced-mesh") && contains(warnings(), ": 1")) << warnings();
    text.json.erase("scene");
    EXPECT_EQ(count_triangles(import(text)), 2U);
    EXPECT_TRUE(contains(warnings(), "warning unplaced-mesh") && contains(warnings(), "origin: 1"))
        << warnings();
}

TEST_F(GltfSourceTest, RejectsLoops) {
    GltfText text;
    text.add_node({{"mesh", text.add_triangle_mesh()}, {"children", {1}}});
    text.json["nodes"].push_back({{"children", {0}}});
    EXPECT_TRUE(contains(refusal(text), "error bad-model") && contains(refusal(text), "nodes/0"));
    text.json["nodes"][1]["children"] = {7};
    EXPECT_TRUE(contains(refusal(text), "nodes/7"));
}

TEST_F(GltfSourceTest, NamesNumbersOutOfRange) {
    folder_.write("x.gltf", R"({"asset": {"version": "2.0"}, "nodes": [{"translation": [0, 1e309, 0]}]})");
    const std::string diagnostic = test::text_of(test::errors_of([&] { import("x.gltf"); }));
    EXPECT_TRUE(contains(diagnostic, "error bad-model") && contains(diagnostic, "'1e309'")) << diagnostic;
}

// ---- materials

/// A triangle with texture coordinates (0,0), (1,0), (0,1) and a material with an image.
GltfText textured_triangle(const Json& image, const Json& texture) {
    GltfText text;
    const std::size_t positions = text.add_triangle_positions();
    const std::size_t uvs = text.add_floats({0, 0, 1, 0, 0, 1}, "VEC2");
    text.json["images"] = Json::array({image});
    text.json["textures"] = Json::array({texture});
    text.json["materials"] = {
        {{"name", "wall"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    text.add_node({{"mesh", text.add_mesh({{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uvs}}},
                                           {"material", 0}})}});
    return text;
}

TEST_F(GltfSourceTest, AppliesTextureTransforms) {
    folder_.write("wood.tga", test::tga_image(1, 1, {1, 2, 3, 255}));
    GltfText text = textured_triangle({{"uri", "wood.tga"}}, {{"source", 0}});
    const Storage<Eigen::Vector2f> plain = import(text).meshes[0].uvs;
    EXPECT_EQ(plain[1], Eigen::Vector2f(1, 0));
    text.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = {
        {"KHR_texture_transform",
         {{"offset", {0.25, 0.5}}, {"rotation", std::numbers::pi / 2}, {"scale", {2, 4}}}}};
    const Storage<Eigen::Vector2f> moved = import(text).meshes[0].uvs;
    // Counter-clockwise on an image whose v points down: right becomes up, down becomes right.
    EXPECT_LT((moved[0] - Eigen::Vector2f(0.25F, 0.5F)).norm(), 1e-6F);
    EXPECT_LT((moved[1] - Eigen::Vector2f(0.25F, 0.5F - 2.0F)).norm(), 1e-6F);
    EXPECT_LT((moved[2] - Eigen::Vector2f(0.25F + 4.0F, 0.5F)).norm(), 1e-6F);
}

TEST_F(GltfSourceTest, DecodesWebp) {
    const std::string image = test::webp_image(3, 2, {10, 200, 30, 255});
    folder_.write("wood.webp", image);
    const Json texture = {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
    const Model model = import(textured_triangle({{"uri", "wood.webp"}}, texture));
    ASSERT_EQ(model.textures.size(), 1U);
    EXPECT_EQ(model.textures[0].width, 3);
    EXPECT_EQ(model.textures[0].height, 2);
    EXPECT_EQ(model.textures[0].rgba.size(), 24U);
    EXPECT_EQ(model.textures[0].rgba[21], 200);
    folder_.write("wood.webp", image.substr(0, image.size() / 2));
    EXPECT_TRUE(import(textured_triangle({{"uri", "wood.webp"}}, texture)).textures.empty());
    EXPECT_TRUE(contains(warnings(), "warning bad-texture") && contains(warnings(), "WebP")) << warnings();
}

TEST_F(GltfSourceTest, WarnsAboutKtxUnlessThereIsAFallback) {
    folder_.write("wood.ktx2", "\xABKTX 20\xBB\r\n\x1A\n and so on");
    folder_.write("wood.tga", test::tga_image(1, 1, {1, 2, 3, 255}));
    Json texture = {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}};
    GltfText text = textured_triangle({{"uri", "wood.ktx2"}}, texture);
    text.json["extensionsUsed"] = {"KHR_texture_basisu"};
    EXPECT_TRUE(import(text).textures.empty());
    EXPECT_TRUE(contains(warnings(), "KTX") && contains(warnings(), "PNG") && contains(warnings(), "'wall'"))
        << warnings();
    texture["source"] = 1;
    text.json["textures"] = Json::array({texture});
    text.json["images"].push_back({{"uri", "wood.tga"}});
    EXPECT_EQ(import(text).textures.size(), 1U);
    EXPECT_EQ(warnings(), "");
}

TEST_F(GltfSourceTest, ReadsAllImagesOfAMaterial) {
    folder_.write("wood.tga", test::tga_image(1, 1, {1, 2, 3, 255}));
    folder_.write("bumps.tga", test::tga_image(1, 1, {128, 128, 255, 255}));
    GltfText text = textured_triangle({{"uri", "wood.tga"}}, {{"source", 0}});
    text.json["images"].push_back({{"uri", "bumps.tga"}});
    text.json["textures"].push_back({{"source", 1}});
    Json& wall = text.json["materials"][0];
    wall["pbrMetallicRoughness"]["metallicFactor"] = 0.25;
    wall["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 1}};
    wall["normalTexture"] = {{"index", 1}, {"scale", 0.5}};
    wall["emissiveTexture"] = {{"index", 0}};
    wall["emissiveFactor"] = {0.5, 0.25, 1.0};
    wall["extensions"] = {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4.0}}},
                          {"KHR_materials_unlit", Json::object()}};
    const Model model = import(text);
    EXPECT_EQ(warnings(), "");
    ASSERT_EQ(model.textures.size(), 2U) << "each is read once";
    const Material& material = model.materials[0];
    EXPECT_EQ(material.base_color_texture, TextureIndex{0});
    EXPECT_EQ(material.metallic_roughness_texture, TextureIndex{1});
    EXPECT_EQ(material.normal_texture, TextureIndex{1});
    EXPECT_EQ(material.emissive_texture, TextureIndex{0});
    EXPECT_EQ(material.metallic, 0.25F);
    EXPECT_EQ(material.roughness, 1.0F) << "the default of glTF";
    EXPECT_EQ(material.normal_scale, 0.5F);
    EXPECT_EQ(material.emissive, (std::array<float, 3>{2.0F, 1.0F, 4.0F}));
    EXPECT_TRUE(material.unlit);
}

TEST_F(GltfSourceTest, IgnoresTexturesOnOtherUvSetsWithAWarning) {
    folder_.write("wood.tga", test::tga_image(1, 1, {1, 2, 3, 255}));
    GltfText text = textured_triangle({{"uri", "wood.tga"}}, {{"source", 0}});
    Json& wall = text.json["materials"][0];
    wall["emissiveFactor"] = {1, 1, 1};
    wall["emissiveTexture"] = {{"index", 0}, {"texCoord", 1}};
    const Material material = import(text).materials[0];
    EXPECT_TRUE(contains(warnings(), "warning unsupported-feature") &&
                contains(warnings(), "'wall': emissiveTexture"))
        << warnings();
    EXPECT_FALSE(material.emissive_texture);
    EXPECT_EQ(material.emissive, (std::array<float, 3>{0, 0, 0})) << "no emission without the texture";
}

TEST_F(GltfSourceTest, ToleratesMissingEmissiveAndNormalImages) {
    folder_.write("wood.tga", test::tga_image(1, 1, {1, 2, 3, 255}));
    GltfText text = textured_triangle({{"uri", "wood.tga"}}, {{"source", 0}});
    text.json["images"].push_back({{"uri", "gone.tga"}});
    text.json["textures"].push_back({{"source", 1}});
    Json& wall = text.json["materials"][0];
    wall["emissiveFactor"] = {1, 1, 1};
    wall["emissiveTexture"] = {{"index", 1}};
    wall["normalTexture"] = {{"index", 1}};
    const Material material = import(text).materials[0];
    EXPECT_TRUE(contains(warnings(), "warning bad-texture") && contains(warnings(), "'gone.tga'"))
        << warnings();
    EXPECT_TRUE(material.base_color_texture);
    EXPECT_FALSE(material.emissive_texture || material.normal_texture);
    EXPECT_EQ(material.emissive, (std::array<float, 3>{0, 0, 0}));
}

// ---- the file

TEST_F(GltfSourceTest, NamesUnsupportedExtensionsAndVersions) {
    GltfText text;
    text.add_node({{"mesh", text.add_triangle_mesh()}});
    text.json["extensionsUsed"] = {"ACME_curved_walls", "KHR_materials_sheen"};
    EXPECT_EQ(count_triangles(import(text)), 1U);
    EXPECT_TRUE(contains(warnings(), "ACME_curved_walls")) << warnings();
    EXPECT_FALSE(contains(warnings(), "sheen")) << warnings();
    text.json["extensionsRequired"] = {"ACME_curved_walls"};
    EXPECT_TRUE(contains(refusal(text), "error bad-model") && contains(refusal(text), "ACME_curved_walls"));
    text.json["asset"]["version"] = "1.0";
    EXPECT_TRUE(contains(refusal(text), "error bad-model") && contains(refusal(text), "'1.0'"));
}

TEST_F(GltfSourceTest, RejectsEveryTruncationOfAGlb) {
    GltfText text;
    text.add_node({{"mesh", text.add_triangle_mesh()}});
    text.write_glb(folder_, "whole.glb");
    std::string bytes(std::filesystem::file_size(folder_.path() / "whole.glb"), '\0');
    std::unique_ptr<FILE, int (*)(FILE*)> in(fopen((folder_.path() / "whole.glb").c_str(), "rb"), fclose);
    ASSERT_EQ(fread(bytes.data(), 1, bytes.size(), in.get()), bytes.size());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        folder_.write("part.glb", bytes.substr(0, size));
        EXPECT_TRUE(test::has_code(test::errors_of([&] { import("part.glb"); }), "bad-model")) << size;
    }
}

}  // namespace
}  // namespace campuswalk::scene
