#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "scene/import/import_model.h"
#include "scene/import/source/decode_image.h"
#include "tests/scene/model_files.h"

namespace campuswalk::scene {
namespace {

using test::scene_file;

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 0 -1\nvt 0 0\nvt 1 0\nvt 0 1\n";

class TextureTest : public testing::Test {
protected:
    /// An OBJ of one triangle with one material, whose lines follow `newmtl wood`.
    ImportedModel imported_with(const std::string& material) {
        folder_.write("x.mtl", "newmtl wood\n" + material);
        folder_.write("x.obj", "mtllib x.mtl\n" + std::string(kTriangle) + "usemtl wood\nf 1/1 2/2 3/3\n");
        return import_model(scene_file(folder_, "x.obj"));
    }
    Model import_with(const std::string& material) { return imported_with(material).model; }
    static const Material& material_of(const Model& model) {
        return model.materials[index_of(model.meshes[0].material)];
    }

    test::TemporaryFolder folder_;
};

TEST_F(TextureTest, RecordsMaterialAndImageLookups) {
    folder_.write("x.mtl", "newmtl wood\nmap_Kd wood.tga\n");
    folder_.write("wood.tga", test::tga_image(1, 1, {1, 2, 3, 255}));
    folder_.write("x.obj", "mtllib x.mtl\n" + std::string(kTriangle) + "usemtl wood\nf 1/1 2/2 3/3\n");
    const std::vector<FileRequest> requests = import_model(scene_file(folder_, "x.obj")).requests;
    EXPECT_EQ(std::ranges::count(requests, FileRequest{"x.mtl", false}), 1);
    EXPECT_EQ(std::ranges::count(requests, FileRequest{"wood.tga", true}), 1);
    std::filesystem::remove(folder_.path() / "x.mtl");
    const std::vector<FileRequest> without = import_model(scene_file(folder_, "x.obj")).requests;
    EXPECT_EQ(std::ranges::count(without, FileRequest{"x.mtl", false}), 1)
        << "the model depends on its absence";
    EXPECT_EQ(std::ranges::count(without, FileRequest{"wood.tga", true}), 0);
}

TEST_F(TextureTest, DecodesRgbaTopRowFirst) {
    folder_.write("maps/wood.tga", test::tga_image(3, 2, {10, 20, 30, 255}));
    const Model model = import_with("Kd 0 0 0\nmap_Kd maps/wood.tga\n");
    ASSERT_EQ(model.textures.size(), 1U);
    EXPECT_EQ(model.textures[0].width, 3);
    EXPECT_EQ(model.textures[0].height, 2);
    ASSERT_EQ(model.textures[0].rgba.size(), 24U);
    EXPECT_EQ(model.textures[0].rgba[0], 10);
    EXPECT_EQ(model.textures[0].rgba[2], 30);
    EXPECT_EQ(model.textures[0].wrap, TextureWrap());
    // A black diffuse colour beside a texture is an exporter's habit, not a black wall.
    EXPECT_EQ(material_of(model).base_color, (std::array<float, 4>{1, 1, 1, 1}));
    EXPECT_EQ(material_of(model).alpha_mode, AlphaMode::opaque);
    // OBJ's v points up, ours down.
    EXPECT_EQ(model.meshes[0].uvs[0], Eigen::Vector2f(0, 1));
    EXPECT_EQ(model.meshes[0].uvs[2], Eigen::Vector2f(0, 0));
}

TEST_F(TextureTest, LoadsASharedImageOnce) {
    folder_.write("wood.tga", test::tga_image(1, 1, {1, 2, 3, 255}));
    folder_.write("x.mtl", "newmtl a\nmap_Kd wood.tga\nnewmtl b\nmap_Kd wood.tga\n");
    folder_.write("x.obj", "mtllib x.mtl\n" + std::string(kTriangle) +
                               "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 2/2 3/3\n");
    EXPECT_EQ(import_model(scene_file(folder_, "x.obj")).model.textures.size(), 1U);
}

TEST_F(TextureTest, TexturesWithHolesSetTheMaskMode) {
    folder_.write("leaf.tga",
                  test::tga_image(1, 1, {0, 255, 0, 255}).replace(12, 1, "\2") + std::string(4, '\0'));
    EXPECT_EQ(material_of(import_with("map_Kd leaf.tga\n")).alpha_mode, AlphaMode::mask);
}

TEST_F(TextureTest, WarnsAboutMissingAndBrokenImagesWithTheirMaterial) {
    const auto missing = imported_with("map_Kd gone.png\n").warnings;
    ASSERT_EQ(missing.size(), 1U);
    EXPECT_EQ(missing[0].code.text(), "bad-texture");
    EXPECT_NE(missing[0].message.find("'wood'"), std::string::npos) << missing[0].message;
    EXPECT_NE(missing[0].message.find("'gone.png'"), std::string::npos) << missing[0].message;

    folder_.write("broken.png", "\x89PNG\r\n\x1a\n and then nothing");
    const auto broken = imported_with("map_Kd broken.png\n").warnings;
    ASSERT_EQ(broken.size(), 1U);
    EXPECT_EQ(broken[0].code.text(), "bad-texture");
    EXPECT_NE(broken[0].message.find("decoded"), std::string::npos) << broken[0].message;
}

TEST_F(TextureTest, SurfacesWithoutTheirTextureArePlain) {
    const Model white = import_with("Kd 1 1 1\nmap_Kd gone.png\n");
    EXPECT_FALSE(material_of(white).base_color_texture);
    EXPECT_EQ(material_of(white).base_color, (std::array<float, 4>{0.5F, 0.5F, 0.5F, 1.0F}));
    const Model tinted = import_with("Kd 1 0 0\nmap_Kd gone.png\n");
    EXPECT_EQ(material_of(tinted).base_color, (std::array<float, 4>{1.0F, 0.0F, 0.0F, 1.0F}));
}

TEST_F(TextureTest, ReportsManyMissingImagesOnceEach) {
    std::string materials;
    std::string faces = kTriangle;
    for (int i = 0; i < 20; ++i) {
        const std::string number = std::to_string(i);
        materials += "newmtl m" + number + "\nmap_Kd gone" + std::to_string(i / 2) + ".png\n";
        faces += "usemtl m" + number + "\nf 1/1 2/2 3/3\n";
    }
    folder_.write("many.mtl", materials);
    folder_.write("many.obj", "mtllib many.mtl\n" + faces);
    const auto warnings = import_model(scene_file(folder_, "many.obj")).warnings;
    ASSERT_EQ(warnings.size(), 6U);
    EXPECT_NE(warnings[4].message.find("'gone4.png'"), std::string::npos) << warnings[4].message;
    EXPECT_NE(warnings[5].message.find("more textures"), std::string::npos) << warnings[5].message;
}

TEST_F(TextureTest, IgnoresMissingImagesOfUnusedMaterials) {
    EXPECT_NO_THROW(import_with("\nnewmtl spare\nmap_Kd gone.png\nnewmtl wood\n"));
}

TEST_F(TextureTest, LegacyOpacityBlendsUnlessItIsZero) {
    const Material glass = material_of(import_with("Kd 1 1 1\nd 0.5\n"));
    EXPECT_EQ(glass.alpha_mode, AlphaMode::blend);
    EXPECT_FLOAT_EQ(glass.base_color[3], 0.5F);
    EXPECT_TRUE(glass.double_sided);
    const Material confused = material_of(import_with("Kd 1 1 1\nd 0\n"));
    EXPECT_EQ(confused.alpha_mode, AlphaMode::opaque);
    EXPECT_FLOAT_EQ(confused.base_color[3], 1.0F);
}

TEST_F(TextureTest, LegacyColoursBecomeLinear) {
    const Material material = material_of(import_with("Kd 0.5 1 0\n"));
    EXPECT_NEAR(material.base_color[0], 0.21404F, 1e-4F);
    EXPECT_FLOAT_EQ(material.base_color[1], 1.0F);
    EXPECT_FLOAT_EQ(material.base_color[2], 0.0F);
}

TEST_F(TextureTest, ReadsGltfAlphaSidesWrapModeAndEmbeddedImages) {
    test::write_gltf(folder_, "box", {{.name = "box", .size = {1, 1, 1}}});
    std::string json;
    {
        const auto path = folder_.path() / "box.gltf";
        std::vector<char> bytes(std::filesystem::file_size(path));
        std::unique_ptr<FILE, int (*)(FILE*)> in(fopen(path.c_str(), "rb"), fclose);
        ASSERT_EQ(fread(bytes.data(), 1, bytes.size(), in.get()), bytes.size());
        json.assign(bytes.begin(), bytes.end());
    }
    const std::string indices = "\"indices\":1";
    json.replace(json.find(indices), indices.size(), indices + ",\"material\":0");
    json.insert(
        1, R"("materials":[{"name":"leaf","doubleSided":true,"alphaMode":"MASK","alphaCutoff":0.25,
        "emissiveFactor":[0.5,0,0],"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,1],
        "baseColorTexture":{"index":0}}}],"textures":[{"source":0,"sampler":0}],
        "samplers":[{"wrapS":33648,"wrapT":33071}],"images":[{"uri":"data:image/png;base64,)"
           "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8DwHwAFBQIAX8jx0gAAAABJRU5ErkJggg=="
           R"("}],)");
    folder_.write("box.gltf", json);
    const Model model = import_model(scene_file(folder_, "box.gltf")).model;
    const Material& material = material_of(model);
    EXPECT_EQ(material.name, "leaf");
    EXPECT_EQ(material.base_color, (std::array<float, 4>{0.5F, 0.25F, 1, 1}));  // linear already
    EXPECT_EQ(material.alpha_mode, AlphaMode::mask);
    EXPECT_FLOAT_EQ(material.alpha_cutoff, 0.25F);
    EXPECT_TRUE(material.double_sided);
    EXPECT_FLOAT_EQ(material.emissive[0], 0.5F);
    ASSERT_TRUE(material.base_color_texture);
    const Texture& texture = model.textures[index_of(*material.base_color_texture)];
    EXPECT_EQ(texture.width, 1);
    EXPECT_EQ(texture.rgba.size(), 4U);
    EXPECT_EQ(texture.wrap, (TextureWrap{Wrap::mirror, Wrap::clamp}));
}

TEST(DecodeImage, ReportsAReasonForFailure) {
    std::string reason;
    EXPECT_FALSE(decode_image({}, reason));
    EXPECT_FALSE(reason.empty());
}

TEST(DecodeImage, RefusesMorePixelsThanTheBytesCanHold) {
    std::string bytes = test::tga_image(1, 1, {1, 2, 3, 255});
    for (const std::size_t side : {13U, 15U}) {
        bytes[side] = 0x3E;  // 15,873 pixels
    }
    std::string reason;
    EXPECT_FALSE(decode_image({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, reason));
    EXPECT_NE(reason.find("too large for so few bytes"), std::string::npos) << reason;
}

}  // namespace
}  // namespace campuswalk::scene
