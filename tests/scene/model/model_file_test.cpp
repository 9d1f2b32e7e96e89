#include "scene/model/model_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "scene/base/checksum.h"
#include "tests/scene/model_files.h"

namespace campuswalk::scene {
namespace {

/// Uses every member, with distinct values.
ImportedModel small_import() {
    ImportedModel imported;
    imported.warnings = {{Severity::warning, {"a.campus.yaml", 3, 7}, "repaired-uvs", "two of them"}};
    imported.requests = {{"a b.bin", false}, {"textures/r.png", true}};
    Model& model = imported.model;
    model.file = "models/a.gltf";
    model.geographic = {-33.25, 151.125, 17.5, {1.0 / 3.0, -2e5, 0.25}};
    model.textures = {{"r.png", 2, 1, {1, 2, 3, 4, 5, 6, 7, 8}, {Wrap::clamp, Wrap::mirror}},
                      {"n.png", 1, 1, {128, 129, 255, 254}, {}}};
    Material red;
    red.name = "red";
    red.base_color = {0.5F, 0.25F, 0.125F, 0.75F};
    red.base_color_texture = TextureIndex{0};
    red.emissive = {0.1F, 0.2F, 0.3F};
    red.emissive_texture = TextureIndex{1};
    red.normal_texture = TextureIndex{1};
    red.normal_scale = 0.7F;
    red.metallic = 0.6F;
    red.roughness = 0.35F;
    red.metallic_roughness_texture = TextureIndex{0};
    red.unlit = true;
    red.alpha_mode = AlphaMode::mask;
    red.alpha_cutoff = 0.4F;
    red.double_sided = true;
    model.materials = {Material{}, red};
    Mesh mesh;
    mesh.name = "wall";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
    mesh.normals = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
    mesh.uvs = {{0, 0.5F}, {1, 0}, {0, 1}, {1, 1}};
    mesh.colors = {{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {13, 14, 15, 16}};
    mesh.triangles = {{0, 1, 2}, {3, 2, 1}};
    mesh.material = MaterialIndex{1};
    Mesh bare;
    bare.positions = {{7, 8, 9}, {-0.0F, 1e-40F, 1e9F}, {4, 5, 6}};
    bare.normals = {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}};
    bare.triangles = {{0, 1, 2}};
    model.meshes = {mesh, bare};
    Node root;
    root.name = "root";
    Node child;
    child.name = "Süd-Flügel";
    child.parent = 0;
    child.X_world_node.topRows<3>() << 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12.0 / 7.0;
    child.meshes = {MeshIndex{1}, MeshIndex{0}};
    model.nodes = {root, child};
    return imported;
}

template <typename Number>
std::vector<std::byte> bytes_of(const Storage<Number>& numbers) {
    const auto bytes = std::as_bytes(std::span(numbers));
    return {bytes.begin(), bytes.end()};
}

void expect_equal(const Mesh& a, const Mesh& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(bytes_of(a.positions), bytes_of(b.positions));
    EXPECT_EQ(bytes_of(a.normals), bytes_of(b.normals));
    EXPECT_EQ(bytes_of(a.uvs), bytes_of(b.uvs));
    EXPECT_EQ(a.colors, b.colors);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.material, b.material);
}

void expect_equal(const Material& a, const Material& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.base_color, b.base_color);
    EXPECT_EQ(a.base_color_texture, b.base_color_texture);
    EXPECT_EQ(a.emissive, b.emissive);
    EXPECT_EQ(a.emissive_texture, b.emissive_texture);
    EXPECT_EQ(a.normal_texture, b.normal_texture);
    EXPECT_EQ(a.normal_scale, b.normal_scale);
    EXPECT_EQ(a.metallic, b.metallic);
    EXPECT_EQ(a.roughness, b.roughness);
    EXPECT_EQ(a.metallic_roughness_texture, b.metallic_roughness_texture);
    EXPECT_EQ(a.unlit, b.unlit);
    EXPECT_EQ(a.alpha_mode, b.alpha_mode);
    EXPECT_EQ(a.alpha_cutoff, b.alpha_cutoff);
    EXPECT_EQ(a.double_sided, b.double_sided);
}

void expect_equal(const Model& a, const Model& b) {
    EXPECT_EQ(a.file, b.file);
    ASSERT_EQ(a.textures.size(), b.textures.size());
    for (std::size_t i = 0; i < a.textures.size(); ++i) {
        EXPECT_EQ(a.textures[i].name, b.textures[i].name);
        EXPECT_EQ(a.textures[i].width, b.textures[i].width);
        EXPECT_EQ(a.textures[i].height, b.textures[i].height);
        EXPECT_EQ(a.textures[i].rgba, b.textures[i].rgba);
        EXPECT_EQ(a.textures[i].wrap, b.textures[i].wrap);
    }
    ASSERT_EQ(a.materials.size(), b.materials.size());
    for (std::size_t i = 0; i < a.materials.size(); ++i) {
        expect_equal(a.materials[i], b.materials[i]);
    }
    ASSERT_EQ(a.meshes.size(), b.meshes.size());
    for (std::size_t i = 0; i < a.meshes.size(); ++i) {
        expect_equal(a.meshes[i], b.meshes[i]);
    }
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    for (std::size_t i = 0; i < a.nodes.size(); ++i) {
        EXPECT_EQ(a.nodes[i].name, b.nodes[i].name);
        EXPECT_EQ(a.nodes[i].parent, b.nodes[i].parent);
        EXPECT_EQ(a.nodes[i].X_world_node, b.nodes[i].X_world_node);
        EXPECT_EQ(a.nodes[i].meshes, b.nodes[i].meshes);
    }
}

/// What read_model_file guarantees.
void expect_valid(const Model& model) {
    for (const Texture& texture : model.textures) {
        EXPECT_EQ(static_cast<double>(texture.rgba.size()), 4.0 * texture.width * texture.height);
    }
    for (const Material& material : model.materials) {
        for (const auto& texture : {material.base_color_texture, material.emissive_texture,
                                    material.normal_texture, material.metallic_roughness_texture}) {
            EXPECT_LT(index_of(texture.value_or(TextureIndex{})), texture ? model.textures.size() : 1);
        }
        EXPECT_LE(material.alpha_mode, AlphaMode::blend);
    }
    for (const Mesh& mesh : model.meshes) {
        EXPECT_LT(index_of(mesh.material), model.materials.size());
        EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
        EXPECT_TRUE(mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size());
        EXPECT_TRUE(mesh.colors.empty() || mesh.colors.size() == mesh.positions.size());
        for (const Eigen::Vector3f& position : mesh.positions) {
            EXPECT_TRUE(position.allFinite());
        }
        for (const auto& triangle : mesh.triangles) {
            for (const std::uint32_t vertex : triangle) {
                EXPECT_LT(vertex, mesh.positions.size());
            }
        }
    }
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        EXPECT_GE(model.nodes[i].parent, -1);
        EXPECT_LT(model.nodes[i].parent, static_cast<int>(i));
        EXPECT_TRUE(model.nodes[i].X_world_node.allFinite());
        for (const MeshIndex mesh : model.nodes[i].meshes) {
            EXPECT_LT(index_of(mesh), model.meshes.size());
        }
    }
}

/// Why the bytes are rejected; empty if they can be read.
std::string rejection_of(std::span<const std::byte> bytes) {
    try {
        const ImportedModel read = read_model_file(bytes);
        expect_valid(read.model);
        return "";
    } catch (const DamagedFile& damage) {
        return damage.what();
    }
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Corrects the checksum, as a forger would.
void fix_header(std::vector<std::byte>& bytes) {
    constexpr std::size_t kChecksumAt = 24;
    const std::uint64_t checksum =
        checksum_of(std::span<const std::byte>(bytes).subspan(kArchiveHeaderBytes));
    std::memcpy(bytes.data() + kChecksumAt, &checksum, sizeof checksum);
}

TEST(ModelFile, RoundTripsEveryMember) {
    const ImportedModel imported = small_import();
    const ImportedModel read = read_model_file(write_model_file(imported));
    expect_equal(read.model, imported.model);
    EXPECT_EQ(read.requests, imported.requests);
    ASSERT_EQ(read.warnings.size(), 1U);
    EXPECT_EQ(to_string(read.warnings[0]), to_string(imported.warnings[0]));
    EXPECT_EQ(read.warnings[0].severity, Severity::warning);
}

TEST(ModelFile, RoundTripsAnEmptyModel) {
    const ImportedModel read = read_model_file(write_model_file({}));
    expect_equal(read.model, Model{});
    EXPECT_TRUE(read.warnings.empty());
    EXPECT_TRUE(read.requests.empty());
}

/// Lists of entries of minimal size are not mistaken for truncated ones.
TEST(ModelFile, RoundTripsManyEntriesOfMinimalSize) {
    constexpr std::size_t kMany = 1000;
    const auto read_back = [](const auto& fill) {
        ImportedModel imported;
        fill(imported);
        return read_model_file(write_model_file(imported));
    };
    EXPECT_EQ(read_back([](auto& i) {
                  i.warnings.resize(kMany, {{}, {}, "z-up", ""});
              }).warnings.size(),
              kMany);
    EXPECT_EQ(read_back([](auto& i) { i.requests.resize(kMany); }).requests.size(), kMany);
    EXPECT_EQ(read_back([](auto& i) { i.model.materials.resize(kMany); }).model.materials.size(), kMany);
    EXPECT_EQ(read_back([](auto& i) { i.model.nodes.resize(kMany); }).model.nodes.size(), kMany);
    const auto meshes = [](auto& i) {
        i.model.materials.resize(1);
        i.model.meshes.resize(kMany);
    };
    EXPECT_EQ(read_back(meshes).model.meshes.size(), kMany);
}

TEST(ModelFile, NamesTheReasonOfARejection) {
    const std::vector<std::byte> whole = write_model_file(small_import());
    EXPECT_TRUE(contains(rejection_of({}), "truncated"));
    EXPECT_TRUE(contains(rejection_of(std::span(whole).first(whole.size() - 1)), "truncated"));
    std::vector<std::byte> longer = whole;
    longer.push_back(std::byte{0});
    EXPECT_TRUE(contains(rejection_of(longer), "trailing"));
    std::vector<std::byte> other = whole;
    other[0] = std::byte{'C'};
    EXPECT_TRUE(contains(rejection_of(other), "another kind"));
    other = whole;
    std::reverse(other.begin() + 8, other.begin() + 12);
    EXPECT_TRUE(contains(rejection_of(other), "byte order"));
    other = whole;
    other[12] = std::byte{0};
    EXPECT_TRUE(contains(rejection_of(other), "version 0, not " + std::to_string(kModelFile.version)));
    other = whole;
    other.back() ^= std::byte{1};
    EXPECT_TRUE(contains(rejection_of(other), "checksum"));
}

TEST(ModelFile, RejectsEveryTruncation) {
    const std::vector<std::byte> whole = write_model_file(small_import());
    for (std::size_t length = 0; length < whole.size(); ++length) {
        // A copy of that size, so that a sanitizer detects reads past the end.
        const std::vector<std::byte> part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
        EXPECT_TRUE(contains(rejection_of(part), "truncated")) << length;
    }
}

TEST(ModelFile, RejectsEveryFlippedBit) {
    std::vector<std::byte> bytes = write_model_file(small_import());
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        for (unsigned bit = 0; bit < 8; ++bit) {
            bytes[at] ^= std::byte{1} << bit;
            EXPECT_NE(rejection_of(bytes), "") << at << " bit " << bit;
            bytes[at] ^= std::byte{1} << bit;
        }
    }
}

TEST(ModelFile, IsRejectedOrValidWhenForged) {
    const std::vector<std::byte> whole = write_model_file(small_import());
    std::size_t refused = 0;
    for (std::size_t at = kArchiveHeaderBytes; at < whole.size(); ++at) {
        for (const int value : {0x01, 0x02, 0x04, 0x08, 0x10, 0x20, 0x40, 0x80, 0xFF}) {
            std::vector<std::byte> bytes = whole;
            bytes[at] ^= static_cast<std::byte>(value);
            fix_header(bytes);
            refused += rejection_of(bytes).empty() ? 0U : 1U;
        }
    }
    EXPECT_GT(refused, whole.size());  // much of a small file are counts and indices
}

TEST(ModelFile, RejectsForgedTruncations) {
    const std::vector<std::byte> whole = write_model_file(small_import());
    for (std::size_t length = kArchiveHeaderBytes; length < whole.size(); ++length) {
        std::vector<std::byte> part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
        const std::uint64_t payload = length - kArchiveHeaderBytes;
        std::memcpy(part.data() + 16, &payload, sizeof payload);
        fix_header(part);
        EXPECT_NE(rejection_of(part), "") << length;
    }
}

TEST(ModelFile, RejectsInvalidModels) {
    const auto rejects = [](const char* what, const auto& spoil) {
        ImportedModel imported = small_import();
        spoil(imported.model);
        return contains(rejection_of(write_model_file(imported)), what);
    };
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(rejects("triangle", [](Model& m) { m.meshes[0].triangles[1][2] = 4; }));
    EXPECT_TRUE(rejects("vertex", [](Model& m) { m.meshes[1].positions[2].y() = kNan; }));
    EXPECT_TRUE(rejects("vertex", [](Model& m) { m.meshes[1].positions[0].x() = -kInfinity; }));
    EXPECT_TRUE(rejects("normal", [](Model& m) { m.meshes[0].normals.pop_back(); }));
    EXPECT_TRUE(rejects("material", [](Model& m) { m.meshes[0].material = MaterialIndex{2}; }));
    EXPECT_TRUE(rejects("parent", [](Model& m) { m.nodes[1].parent = 1; }));
    EXPECT_TRUE(rejects("parent", [](Model& m) { m.nodes[0].parent = -2; }));
    EXPECT_TRUE(rejects("node", [](Model& m) { m.nodes[1].meshes[0] = MeshIndex{2}; }));
    EXPECT_TRUE(rejects("transform", [](Model& m) { m.nodes[1].X_world_node(1, 3) = std::nan(""); }));
    EXPECT_TRUE(rejects("pixels", [](Model& m) { m.textures[0].width = 1; }));
    for (const auto texture : {&Material::base_color_texture, &Material::emissive_texture,
                               &Material::normal_texture, &Material::metallic_roughness_texture}) {
        EXPECT_TRUE(rejects("texture", [&](Model& m) { m.materials[1].*texture = TextureIndex{2}; }));
    }
    for (const auto number : {&Material::normal_scale, &Material::metallic, &Material::roughness}) {
        EXPECT_TRUE(rejects("colour", [&](Model& m) { m.materials[1].*number = std::nanf(""); }));
    }
}

}  // namespace
}  // namespace campuswalk::scene
