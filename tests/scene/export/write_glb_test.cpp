#include "scene/export/write_glb.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "scene/import/import_model.h"
#include "scene/model/world_triangles.h"
#include "tests/support/dice.h"
#include "tests/support/temporary_folder.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;
using support::Dice;
using support::TemporaryFolder;
using Triangle = std::array<Vector3d, 3>;

std::vector<Triangle> triangles_of(const Model& model) {
    std::vector<Triangle> triangles;
    for (const Node& node : model.nodes) {
        for_each_triangle(model, node, [&](const auto& a, const auto& b, const auto& c) {
            triangles.push_back({a, b, c});
        });
    }
    return triangles;
}

/// Ericson, Real-Time Collision Detection, 5.1.5, written anew: by brute force it is the oracle here.
double distance_to(const Triangle& t, const Vector3d& p) {
    const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
    if (normal.squaredNorm() > 0.0) {
        const Vector3d flat = p - normal * (normal.dot(p - t[0]) / normal.squaredNorm());
        bool inside = true;
        for (std::size_t i = 0; i < 3; ++i) {
            inside = inside && normal.dot((t[(i + 1) % 3] - t[i]).cross(flat - t[i])) >= 0.0;
        }
        if (inside) {
            return (p - flat).norm();
        }
    }
    double least = 1e300;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector3d edge = t[(i + 1) % 3] - t[i];
        const double length = edge.squaredNorm();
        const double at = length > 0.0 ? std::clamp(edge.dot(p - t[i]) / length, 0.0, 1.0) : 0.0;
        least = std::min(least, (p - t[i] - at * edge).norm());
    }
    return least;
}

/// The greatest distance of some points of `from` to the surface `to`.
double hausdorff_sample(const std::vector<Triangle>& from, const std::vector<Triangle>& to, Dice& dice,
                        int samples) {
    double most = 0.0;
    for (int i = 0; i < samples; ++i) {
        const Triangle& t = from[static_cast<std::size_t>(dice.below(static_cast<int>(from.size())))];
        double u = dice.between(0.0, 1.0);
        double v = dice.between(0.0, 1.0);
        if (u + v > 1.0) {
            u = 1.0 - u;
            v = 1.0 - v;
        }
        const Vector3d p = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
        double least = 1e300;
        for (const Triangle& other : to) {
            least = std::min(least, distance_to(other, p));
        }
        most = std::max(most, least);
    }
    return most;
}

GlbFile write(const Model& model, double error) {
    GlbSettings settings;
    settings.error = error;
    return write_glb(std::span(&model, 1), settings,
                     [](std::size_t, std::size_t node) { return Tags{static_cast<std::uint32_t>(node)}; });
}

/// What our own importer makes of the file.
Model read_back(const GlbFile& glb) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "a.glb";
    std::ofstream(file, std::ios::binary) << glb.bytes;
    SceneFile scene;
    scene.file = "a.glb";
    scene.path = file;
    ImportedModel imported = import_model(scene);
    EXPECT_TRUE(imported.warnings.empty()) << imported.warnings.front().message;
    return std::move(imported.model);
}

nlohmann::json json_of(const GlbFile& glb) {
    const auto size = static_cast<unsigned char>(glb.bytes[12]) +
                      256U * static_cast<unsigned char>(glb.bytes[13]) +
                      65536U * static_cast<unsigned char>(glb.bytes[14]);
    return nlohmann::json::parse(glb.bytes.substr(20, size));
}

/// A hilly square of `cells` x `cells` cells of a metre, about the origin, smoothly shaded.
Model hills(int cells) {
    Model model;
    model.materials.emplace_back();
    Mesh mesh;
    const auto height = [](double x, double z) { return 0.6 * std::sin(0.3 * x) + 0.4 * std::cos(0.21 * z); };
    for (int i = 0; i <= cells; ++i) {
        for (int j = 0; j <= cells; ++j) {
            const double x = i - cells / 2.0;
            const double z = j - cells / 2.0;
            mesh.positions.push_back(Vector3d(x, height(x, z), z).cast<float>());
            mesh.normals.push_back(Vector3d(-0.18 * std::cos(0.3 * x), 1.0, 0.084 * std::sin(0.21 * z))
                                       .normalized()
                                       .cast<float>());
            mesh.uvs.push_back({static_cast<float>(x), static_cast<float>(z)});
        }
    }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i * (cells + 1) + j); };
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
        }
    }
    model.meshes.push_back(std::move(mesh));
    Node node;
    node.name = "hills";
    node.meshes = {MeshIndex(0)};
    model.nodes.push_back(std::move(node));
    return model;
}

TEST(WriteGlb, AnExactFileHasEveryTriangle) {
    const Model model = hills(40);
    const GlbFile glb = write(model, 0.0);
    EXPECT_EQ(glb.triangles, 40U * 40U * 2U);
    const std::vector<Triangle> there = triangles_of(model);
    const std::vector<Triangle> back = triangles_of(read_back(glb));
    EXPECT_EQ(back.size(), there.size());
    Dice dice(1);
    EXPECT_LT(hausdorff_sample(there, back, dice, 300), 1e-5);
    EXPECT_LT(hausdorff_sample(back, there, dice, 300), 1e-5);
}

TEST(WriteGlb, ASimplifiedFileStaysWithinItsError) {
    const Model model = hills(100);
    const std::vector<Triangle> there = triangles_of(model);
    std::size_t last = there.size();
    for (const double error : {0.01, 0.05, 0.2}) {
        const GlbFile glb = write(model, error);
        EXPECT_EQ(glb.source_triangles, there.size());
        EXPECT_LT(glb.triangles, last) << error;
        last = glb.triangles;
        const std::vector<Triangle> back = triangles_of(read_back(glb));
        EXPECT_EQ(back.size(), glb.triangles);
        Dice dice(2);
        EXPECT_LE(hausdorff_sample(there, back, dice, 400), error);
        EXPECT_LE(hausdorff_sample(back, there, dice, 400), error);
    }
}

/// The open edges of a surface, which a crack between two groups would add to.
std::size_t open_edges(const std::vector<Triangle>& triangles) {
    using Key = std::array<std::int64_t, 6>;
    std::map<Key, int> edges;
    const auto whole = [](double value) { return static_cast<std::int64_t>(std::llround(value * 1e4)); };
    for (const Triangle& t : triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            std::array<std::int64_t, 3> a = {whole(t[i].x()), whole(t[i].y()), whole(t[i].z())};
            const Vector3d& q = t[(i + 1) % 3];
            std::array<std::int64_t, 3> b = {whole(q.x()), whole(q.y()), whole(q.z())};
            if (b < a) {
                std::swap(a, b);
            }
            ++edges[{a[0], a[1], a[2], b[0], b[1], b[2]}];
        }
    }
    return static_cast<std::size_t>(
        std::ranges::count_if(edges, [](const auto& edge) { return edge.second == 1; }));
}

TEST(WriteGlb, GroupsJoinWithoutACrack) {
    const Model model = hills(150);  // nine squares of 64 m
    const GlbFile glb = write(model, 0.1);
    EXPECT_LT(glb.triangles, glb.source_triangles / 2);
    EXPECT_EQ(json_of(glb).at("nodes").size(), 16U);
    EXPECT_EQ(open_edges(triangles_of(read_back(glb))), 4U * 150U);
}

TEST(WriteGlb, FlatFacesShareVerticesWithoutNormals) {
    Model model;
    model.materials.emplace_back();
    Mesh mesh;
    const std::array<Vector3d, 4> p = {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0),
                                       Vector3d(0, 0, 1)};
    for (const auto& t :
         {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{0, 3, 2}, std::array{1, 2, 3}}) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        const auto k = [&](std::size_t i) { return p[static_cast<std::size_t>(t[i])]; };
        const Vector3d normal = (k(1) - k(0)).cross(k(2) - k(0)).normalized();
        for (std::size_t i = 0; i < 3; ++i) {
            mesh.positions.push_back(k(i).cast<float>());
            mesh.normals.push_back(normal.cast<float>());
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    model.meshes.push_back(mesh);
    Node node;
    node.meshes = {MeshIndex(0)};
    model.nodes.push_back(node);
    const nlohmann::json json = json_of(write(model, 0.05));
    const nlohmann::json& attributes = json.at("meshes")[0].at("primitives")[0].at("attributes");
    EXPECT_FALSE(attributes.contains("NORMAL"));
    EXPECT_EQ(json.at("accessors")[attributes.at("POSITION").get<std::size_t>()].at("count"), 4);
}

TEST(WriteGlb, NodesAreTaggedAndNamed) {
    Model model = hills(8);
    model.nodes.push_back(model.nodes.front());
    model.nodes[1].name = "again \"<&";
    model.nodes[1].X_world_node(1, 3) = 5.0;
    const nlohmann::json json = json_of(write(model, 0.05));
    std::map<std::string, nlohmann::json> tags;
    for (const nlohmann::json& node : json.at("nodes")) {
        tags[node.at("extras").at("node")] = node.at("extras").at("objects");
    }
    EXPECT_EQ(tags.at("hills"), nlohmann::json::array({0}));
    EXPECT_EQ(tags.at("again \"<&"), nlohmann::json::array({1}));
}

TEST(WriteGlb, MaterialsComeBackAsTheyWere) {
    Model model = hills(4);
    Texture texture;
    texture.width = 1024;
    texture.height = 512;
    texture.wrap = {Wrap::mirror, Wrap::clamp};
    texture.rgba.resize(std::size_t{4} * 1024 * 512, 200);
    model.textures.push_back(std::move(texture));
    Material& material = model.materials.front();
    material.base_color = {0.5F, 0.25F, 1.0F, 0.75F};
    material.base_color_texture = TextureIndex(0);
    material.metallic = 0.25F;
    material.roughness = 0.5F;
    material.emissive = {2.0F, 1.0F, 0.5F};
    material.alpha_mode = AlphaMode::mask;
    material.alpha_cutoff = 0.25F;
    material.double_sided = true;
    const Model back = read_back(write(model, 0.05));
    const Material& copy = back.materials.at(index_of(back.meshes.front().material));
    EXPECT_EQ(copy.base_color, material.base_color);
    EXPECT_EQ(copy.metallic, material.metallic);
    EXPECT_EQ(copy.roughness, material.roughness);
    EXPECT_EQ(copy.emissive, material.emissive);
    EXPECT_EQ(copy.alpha_mode, material.alpha_mode);
    EXPECT_EQ(copy.alpha_cutoff, material.alpha_cutoff);
    EXPECT_TRUE(copy.double_sided);
    ASSERT_EQ(back.textures.size(), 1U);
    EXPECT_EQ(back.textures[0].width, 512);
    EXPECT_EQ(back.textures[0].height, 256);
    EXPECT_EQ(back.textures[0].wrap, (TextureWrap{Wrap::mirror, Wrap::clamp}));
    EXPECT_NEAR(back.textures[0].rgba[0], 200, 3);
}

TEST(WriteGlb, EqualModelsGiveEqualBytes) {
    EXPECT_EQ(write(hills(70), 0.05).bytes, write(hills(70), 0.05).bytes);
}

TEST(WriteGlb, AnEmptyModelIsAValidFile) {
    const GlbFile glb = write(Model(), 0.05);
    EXPECT_EQ(glb.triangles, 0U);
    EXPECT_FALSE(json_of(glb).contains("nodes"));
}

/// Real models, as far as they are there: the surface within the error, as our importer reads it.
class RealModels : public ::testing::TestWithParam<const char*> {};

TEST_P(RealModels, StayWithinTheError) {
    const std::filesystem::path file = std::filesystem::path(CAMPUSWALK_SHARED_DATA) / GetParam();
    if (!std::filesystem::exists(file)) {
        GTEST_SKIP() << file << " isn't there";
    }
    SceneFile scene;
    scene.file = file.filename().string();
    scene.path = file;
    Model model = import_model(scene).model;
    move_origin(model, origin_near(world_bounds(model)));
    const GlbFile glb = write(model, 0.05);
    const std::vector<Triangle> there = triangles_of(model);
    const std::vector<Triangle> back = triangles_of(read_back(glb));
    EXPECT_EQ(glb.source_triangles >= glb.triangles, true);
    Dice dice(3);
    EXPECT_LE(hausdorff_sample(there, back, dice, 60), 0.05);
    EXPECT_LE(hausdorff_sample(back, there, dice, 60), 0.05);
}

INSTANTIATE_TEST_SUITE_P(Files, RealModels,
                         ::testing::Values("small_house/small_house_visual.glb", "trimesh/Duck.glb",
                                           "recast/dungeon.obj", "recast/undulating.obj",
                                           "gazebo/parking_garage/meshes/parking_garage.dae"));

}  // namespace
}  // namespace campuswalk::scene
