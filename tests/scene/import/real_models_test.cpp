// Third-party files, checked against figures that don't come from our importer: the conformance corpus' own
// reports, a reader of ten lines, and published sizes.

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "scene/import/import_model.h"
#include "tests/scene/model_files.h"

namespace campuswalk::scene {
namespace {

namespace fs = std::filesystem;

class RealModels : public testing::Test {
protected:
    void SetUp() override {
        if (test::shared_data().empty()) {
            GTEST_SKIP() << "no models at " << CAMPUSWALK_SHARED_DATA;
        }
    }
    static Model import(const std::string& name) { return import_model(test::shared_scene(name)).model; }
};

struct ObjFigures {
    std::size_t triangles = 0;
    Bounds bounds;  // of the vertices that faces use
};

ObjFigures read_obj(const fs::path& path) {
    ObjFigures figures;
    std::vector<Eigen::Vector3d> positions;
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "v") {
            Eigen::Vector3d p;
            words >> p.x() >> p.y() >> p.z();
            positions.push_back(p);
        } else if (word == "f") {
            std::size_t vertices = 0;
            while (words >> word) {
                const long index = std::stol(word);
                figures.bounds.extend(positions[static_cast<std::size_t>(index > 0 ? index - 1 : 0)]);
                ++vertices;
            }
            figures.triangles += vertices - 2;
        }
    }
    return figures;
}

TEST_F(RealModels, ObjFilesHaveTheTrianglesAndBoundsOfTheirText) {
    for (const char* name : {"recast/dungeon.obj", "recast/nav_test.obj", "recast/undulating.obj",
                             "ufaz/after153/outdoor_campus.obj", "ufaz/before128/ufaz-floor.obj"}) {
        const ObjFigures figures = read_obj(test::shared_data() / name);
        const Model model = import(name);
        EXPECT_EQ(count_triangles(model), figures.triangles) << name;
        // float32 at 5 km from the origin: half a millimetre.
        EXPECT_LT((world_bounds(model).min - figures.bounds.min).norm(), 1e-3) << name;
        EXPECT_LT((world_bounds(model).max - figures.bounds.max).norm(), 1e-3) << name;
    }
}

TEST_F(RealModels, ZUpMapIsConvertedToYUp) {
    SceneFile file = test::shared_scene("delft_3dfier/testarea.obj");
    file.up = UpAxis::z;
    file.position = {-84616, 0, 447750};
    const ObjFigures figures = read_obj(file.path);
    const Model model = import_model(file).model;
    EXPECT_EQ(count_triangles(model), figures.triangles);
    const Bounds bounds = world_bounds(model);
    // Heights of a Dutch district; x runs east, -z north. Coordinates of 450 km come on a 3 cm grid.
    EXPECT_NEAR(bounds.min.y(), figures.bounds.min.z(), 0.001);
    EXPECT_NEAR(bounds.max.y(), figures.bounds.max.z(), 0.001);
    EXPECT_NEAR(bounds.max.z(), 447750 - figures.bounds.min.y(), 0.04);
    EXPECT_NEAR(bounds.max.x(), figures.bounds.max.x() - 84616, 0.04);
}

TEST_F(RealModels, ColladaUnitsAndAxesAreApplied) {
    // Inches and Z-up in the file; levels 5.6 m apart from 0 to 39 m in the world.
    const Model model = import("gazebo/parking_garage/meshes/parking_garage.dae");
    std::map<int, double> floor_area;  // by height in whole metres
    for (const Node& node : model.nodes) {
        for (const MeshIndex index : node.meshes) {
            const Mesh& mesh = model.meshes[index_of(index)];
            for (const auto& t : mesh.triangles) {
                std::array<Eigen::Vector3d, 3> p;
                for (std::size_t k = 0; k < 3; ++k) {
                    const Eigen::Vector4d local = mesh.positions[t[k]].cast<double>().homogeneous();
                    p[k] = (node.X_world_node * local).head<3>();
                }
                const Eigen::Vector3d n = (p[1] - p[0]).cross(p[2] - p[0]);
                if (n.y() > 0.99 * n.norm()) {
                    floor_area[static_cast<int>((p[0].y() + p[1].y() + p[2].y()) / 3.0)] += 0.5 * n.norm();
                }
            }
        }
    }
    EXPECT_GT(floor_area[0], 1500.0);
    EXPECT_GT(floor_area[39], 1500.0);
    EXPECT_NEAR(world_bounds(model).min.y(), 0.0, 0.1);
    EXPECT_EQ(model.textures.size(), 1U);  // referred to by base name, found in ../materials/textures
}

TEST_F(RealModels, GazeboOfficesHaveTheirSizes) {
    const Bounds office = world_bounds(import("gazebo/willowgarage/meshes/willowgarage_collision.dae"));
    EXPECT_NEAR(office.max.x() - office.min.x(), 58.6, 0.5);
    EXPECT_NEAR(office.max.z() - office.min.z(), 45.7, 0.5);
    EXPECT_NEAR(office.min.y(), 0.0, 0.01);
    const Model cafe = import("gazebo/cafe/meshes/cafe.dae");
    EXPECT_EQ(cafe.textures.size(), 15U);
    EXPECT_FALSE(match_nodes(cafe, "instance_0").empty());
    // A node without a name gets its id.
    EXPECT_FALSE(
        match_nodes(import("gazebo/nist_stairs_120/meshes/nist_stairs_120.dae"), "Plane_001").empty());
}

TEST_F(RealModels, SmallHouseIsComplete) {
    const Model model = import("small_house/small_house_visual.glb");
    EXPECT_NEAR(static_cast<double>(count_triangles(model)), 146e3, 1e3);
    EXPECT_EQ(count_triangles(import("small_house/small_house_collision.glb")), 4131U);
    EXPECT_FALSE(match_nodes(model, "aws_robomaker_residential_Bed_01").empty());
}

/// Files with a report.
std::vector<fs::path> gltf_files(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const fs::path& path = entry.path();
        if ((path.extension() == ".gltf" || path.extension() == ".glb") &&
            fs::exists(path.string() + ".report.json")) {
            files.push_back(path);
        }
    }
    std::ranges::sort(files);
    return files;
}

/// The value of a key such as `"numErrors": 0` in a report.
int figure(const std::string& report, const std::string& key) {
    std::smatch match;
    return std::regex_search(report, match, std::regex('"' + key + "\": (\\d+)")) ? std::stoi(match[1]) : -1;
}

TEST_F(RealModels, ConformanceFilesWithoutErrorsHaveTheReportedTriangles) {
    int without_errors = 0;
    int refused = 0;
    for (const fs::path& path : gltf_files(test::shared_data() / "gltf_validator")) {
        std::stringstream report;
        report << std::ifstream(path.string() + ".report.json").rdbuf();
        SceneFile file;
        file.path = path;
        file.file = path.filename().string();
        std::size_t triangles = 0;
        const auto errors = test::errors_of(
            [&] { triangles = count_triangles(import_model(file, EmptyModel::accept).model); });
        if (figure(report.str(), "numErrors") == 0) {
            ++without_errors;
            EXPECT_TRUE(errors.empty()) << path << test::text_of(errors);
            EXPECT_EQ(static_cast<int>(triangles), std::max(figure(report.str(), "totalTriangleCount"), 0))
                << path;
        }
        refused += errors.empty() ? 0 : 1;
        EXPECT_LE(errors.size(), 1U) << path << test::text_of(errors);
    }
    EXPECT_EQ(without_errors, 129);
    EXPECT_GT(refused, 30);
}

/// Triangle counts from other readers.
TEST_F(RealModels, GltfFilesHaveTheTrianglesOfOtherReaders) {
    const std::vector<std::pair<const char*, std::size_t>> known = {
        {"BoxInterleaved.glb", 12}, {"BoxTextured.glb", 12}, {"Duck.glb", 4212},
        {"cubevc.glb", 48},         {"monkey.glb", 968},     {"Mesh_PrimitiveMode_04.gltf", 2}};
    for (const auto& [name, triangles] : known) {
        EXPECT_EQ(count_triangles(import(std::string("trimesh/") + name)), triangles) << name;
    }
}

}  // namespace
}  // namespace campuswalk::scene
