#include <chrono>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "collision/mesh/mesh_collider.h"
#include "scene/cache/load_model.h"
#include "scene/campus/cached_meshes.h"
#include "scene/campus/campus.h"
#include "tests/scene/model_files.h"
#include "tests/support/full_disk.h"

namespace campuswalk::scene {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 0 -1\nvt 0 0\nvt 1 0\nvt 0 1\n";

/// An OBJ with a material and an image, and how often it is imported.
class CachedCampus : public testing::Test {
protected:
    void SetUp() override {
        folder_.write("a/x.mtl", "newmtl wood\nmap_Kd wood.tga\n");
        folder_.write("a/wood.tga", test::tga_image(1, 1, {10, 20, 30, 255}));
        folder_.write("a/x.obj", "mtllib x.mtl\n" + std::string(kTriangle) +
                                     "o wing\nusemtl wood\nf 1/1 2/2 3/3\nf 1/1 2/2 2/2\nl 1 2\n" +
                                     test::obj_box("tower", {4, 0, 4}, {5, 3, 5}, 4));
        file_ = test::scene_file(folder_, "a/x.obj");
    }

    Importer counting() {
        return [this](const SceneFile& file, EmptyModel if_empty) {
            ++imports_;
            return import_model(file, if_empty);
        };
    }
    LoadedModel load() { return load_model(file_, EmptyModel::refuse, counting(), &cache_); }
    /// Whether it was imported.
    bool imports() {
        const int before = imports_;
        load();
        return imports_ > before;
    }

    Campus campus(std::vector<Diagnostic>& warnings, const CacheFolder* cache) {
        CampusDescription description;
        description.scenes = {file_};
        Building tower;
        tower.id = "tower";
        tower.nodes = {{{}, "tower"}};
        description.buildings = {tower};
        for (const std::string id : {"all", "each", "tower"}) {
            ColliderDescription collider;
            collider.id = id;
            collider.each = id == "each";
            collider.building = id == "tower" ? "tower" : "";
            collider.modes.solid = true;
            collider.shape = MeshShape{};
            if (id != "tower") {
                collider.nodes = {{{}, "wing"}, {{}, "tower"}};
            }
            description.colliders.push_back(collider);
        }
        return load_campus(description, std::make_unique<collision::LinearBroadPhase>(), warnings, counting(),
                           cache);
    }
    std::vector<fs::path> files(const std::string& kind) const {
        std::vector<fs::path> found;
        for (const auto& entry : fs::directory_iterator(where_)) {
            if (entry.path().string().ends_with("." + kind + ".campuswalk")) {
                found.push_back(entry.path());
            }
        }
        return found;
    }

    test::TemporaryFolder folder_;
    fs::path where_ = folder_.path() / "cache";
    CacheFolder cache_{where_};
    SceneFile file_;
    int imports_ = 0;
};

TEST_F(CachedCampus, ImportsAModelOnce) {
    const LoadedModel cold = load();
    const LoadedModel warm = load();
    EXPECT_EQ(imports_, 1);
    EXPECT_EQ(warm.contents, cold.contents);
    EXPECT_EQ(write_model_file(warm.imported), write_model_file(cold.imported));
    EXPECT_EQ(warm.imported.model.textures.size(), 1U);
    ASSERT_FALSE(warm.imported.warnings.empty());
}

TEST_F(CachedCampus, ImportsAgainWhenAnyOfItsFilesHasChanged) {
    load();
    folder_.write("a/wood.tga", test::tga_image(1, 1, {11, 20, 30, 255}));
    EXPECT_TRUE(imports());
    folder_.write("a/x.mtl", "newmtl wood\nmap_Kd wood.tga\nKd 0.5 0 0\n");
    EXPECT_TRUE(imports());
    fs::remove(folder_.path() / "a/x.mtl");
    EXPECT_TRUE(imports());
    folder_.write("a/x.mtl", "newmtl wood\n");
    EXPECT_TRUE(imports()) << "a file that was missing has appeared";
    std::ofstream(folder_.path() / "a/x.obj", std::ios::app) << "# a comment\n";
    EXPECT_TRUE(imports());
    EXPECT_FALSE(imports());
}

/// An image in a nearer folder takes precedence over the one that was found before.
TEST_F(CachedCampus, ImportsAgainWhenAnotherFileIsFound) {
    fs::create_directories(folder_.path() / "a/textures");
    fs::rename(folder_.path() / "a/wood.tga", folder_.path() / "a/textures/wood.tga");
    load();
    EXPECT_FALSE(imports());
    folder_.write("a/wood.tga", test::tga_image(1, 1, {99, 20, 30, 255}));
    EXPECT_TRUE(imports());
}

TEST_F(CachedCampus, ImportsAgainForOtherSettings) {
    load();
    file_.up = UpAxis::z;
    EXPECT_TRUE(imports());
    file_.scale = 2.0;
    EXPECT_TRUE(imports());
    file_.metres_per_unit = 0.01;
    EXPECT_TRUE(imports());
    file_.position.z() = 1.0;
    EXPECT_TRUE(imports());
    file_.file = "as/the/user/named/it.obj";
    EXPECT_TRUE(imports());
    EXPECT_FALSE(imports());
}

TEST_F(CachedCampus, MarksCachedWarningsAtTheCurrentReference) {
    load();
    file_.mark = {"other.campus.yaml", 7, 3};
    const LoadedModel warm = load();
    EXPECT_EQ(imports_, 1);
    EXPECT_EQ(warm.imported.warnings.at(0).mark.file, "other.campus.yaml");
    EXPECT_EQ(warm.imported.warnings.at(0).mark.line, 7);
}

TEST_F(CachedCampus, DoesNotCacheFailedImports) {
    folder_.write("a/x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\n");
    for (int i = 1; i <= 2; ++i) {
        EXPECT_FALSE(test::errors_of([&] { load(); }).empty());
        EXPECT_EQ(imports_, i);
    }
}

TEST_F(CachedCampus, ReplacesDamagedFiles) {
    load();
    for (const char* kind : {"model", "requests"}) {
        ASSERT_EQ(files(kind).size(), 1U);
        fs::resize_file(files(kind)[0], fs::file_size(files(kind)[0]) - 1);
        EXPECT_TRUE(imports()) << kind;
        EXPECT_FALSE(imports()) << kind;
    }
}

TEST_F(CachedCampus, EqualsTheCampusThatIsLoadedWithoutACache) {
    std::vector<Diagnostic> without_warnings;
    const Campus without = campus(without_warnings, nullptr);
    EXPECT_FALSE(fs::exists(where_));
    std::vector<Diagnostic> cold_warnings;
    campus(cold_warnings, &cache_);
    ASSERT_EQ(files("trees").size(), 1U);
    imports_ = 0;
    std::vector<Diagnostic> warm_warnings;
    const Campus warm = campus(warm_warnings, &cache_);
    EXPECT_EQ(imports_, 0);
    EXPECT_EQ(test::text_of(warm_warnings), test::text_of(without_warnings));
    EXPECT_EQ(test::text_of(cold_warnings), test::text_of(without_warnings));
    EXPECT_TRUE(test::has_code(warm_warnings, "zero-area"));
    ASSERT_EQ(warm.objects.size(), without.objects.size());
    for (std::size_t i = 0; i < warm.objects.size(); ++i) {
        EXPECT_EQ(warm.objects[i].id, without.objects[i].id);
        const auto& a = warm.world.object(static_cast<collision::ObjectId>(i));
        const auto& b = without.world.object(static_cast<collision::ObjectId>(i));
        EXPECT_EQ(a.X_world_shape.translation, b.X_world_shape.translation);
        EXPECT_EQ(std::get<0>(a.shape)->mesh().triangles, std::get<0>(b.shape)->mesh().triangles);
        EXPECT_EQ(std::get<0>(a.shape)->mesh().positions, std::get<0>(b.shape)->mesh().positions);
    }
}

/// Each object gets its own mesh from the cache, in whatever order they are stored and found.
TEST_F(CachedCampus, FindsMeshesByTheirObjects) {
    CampusDescription description;
    description.scenes = {file_};
    for (const std::string id : {"wing", "tower"}) {
        ColliderDescription collider;
        collider.id = id;
        collider.modes.solid = true;
        collider.shape = MeshShape{};
        collider.nodes = {{{}, id}};
        description.colliders.push_back(collider);
    }
    const std::vector<ContentHash> models(1);
    std::vector<Diagnostic> warnings;
    const Campus made =
        load_campus(description, std::make_unique<collision::LinearBroadPhase>(), warnings, counting());
    const auto shape = [&](std::size_t i) {
        const auto& object = made.world.object(static_cast<collision::ObjectId>(i));
        return PlacedShape{object.shape, object.X_world_shape, 0};
    };
    CachedMeshes cold(cache_, description, Eigen::Vector3d::Zero(), models);
    EXPECT_FALSE(cold.find("wing"));
    cold.add("tower", shape(1));
    cold.add("wing", shape(0));
    cold.keep();
    const CachedMeshes warm(cache_, description, Eigen::Vector3d::Zero(), models);
    for (const std::size_t i : {1U, 0U}) {
        const auto found = warm.find(description.colliders[i].id);
        ASSERT_TRUE(found) << i;
        EXPECT_EQ(found->X_world_shape.translation, shape(i).X_world_shape.translation);
        EXPECT_EQ(std::get<0>(found->shape)->mesh().positions, std::get<0>(shape(i).shape)->mesh().positions);
    }
    EXPECT_FALSE(warm.find("roof"));
}

TEST_F(CachedCampus, RebuildsDamagedTrees) {
    std::vector<Diagnostic> warnings;
    campus(warnings, &cache_);
    const fs::path trees = files("trees").at(0);
    const std::uintmax_t size = fs::file_size(trees);
    fs::resize_file(trees, size / 2);
    EXPECT_EQ(campus(warnings, &cache_).world.size(), 4U);
    EXPECT_EQ(fs::file_size(trees), size);
}

TEST_F(CachedCampus, WorksWithoutAWritableCacheFolder) {
    folder_.write("file", "not a folder");
    const CacheFolder nowhere(folder_.path() / "file" / "cache");
    std::vector<Diagnostic> warnings;
    EXPECT_EQ(campus(warnings, &nowhere).world.size(), 4U);
    EXPECT_EQ(campus(warnings, &nowhere).world.size(), 4U);
    EXPECT_EQ(imports_, 2);
}

TEST_F(CachedCampus, LeavesNoPartialFilesOnAFullDisk) {
    std::vector<Diagnostic> warnings;
    std::vector<std::string> diagnostics;
    const CacheFolder cache(where_, CacheFolder::kDefaultLimit,
                            [&](const std::string& reason) { diagnostics.push_back(reason); });
    for (const rlim_t bytes : {rlim_t{0}, rlim_t{200}}) {
        const campuswalk::test::FullDisk full(bytes);
        EXPECT_EQ(campus(warnings, &cache).world.size(), 4U);
        // Small files fit into 200 bytes: the requests and the hash of this program.
        std::erase_if(diagnostics, [](const std::string& line) { return line.find(".stamp.") != line.npos; });
        EXPECT_EQ(diagnostics.size(), bytes == 0 ? 3U : 5U);
    }
    for (const auto& entry : fs::directory_iterator(where_)) {
        const std::string name = entry.path().string();
        EXPECT_TRUE(name.ends_with(".requests.campuswalk") || name.ends_with(".stamp.campuswalk")) << name;
    }
    EXPECT_EQ(imports_, 2);
    EXPECT_EQ(campus(warnings, &cache).world.size(), 4U);
    EXPECT_EQ(campus(warnings, &cache).world.size(), 4U);
    EXPECT_EQ(imports_, 3);
}

/// Diagnostics come in the order of the scenes, whichever import finishes first.
TEST_F(CachedCampus, ReportsTheSameWithConcurrentImports) {
    const auto reported = [&](std::size_t concurrent, bool broken) {
        const Importer slow_at_first = [&](const SceneFile& file, EmptyModel if_empty) {
            const int number = file.file.back() - '0';
            std::this_thread::sleep_for(std::chrono::milliseconds(4 * (5 - number)));
            if (broken && number % 2 == 0) {
                throw InputError(file.mark, "bad-model", file.file + " is broken");
            }
            ImportedModel imported = import_model(file_, if_empty);
            imported.warnings = {{Severity::warning, {}, "odd-scale", file.file + " is odd"}};
            return imported;
        };
        CampusDescription description;
        for (const char* name : {"m0", "m1", "m2", "m3", "m4"}) {
            description.scenes.push_back(file_);
            description.scenes.back().file = name;
        }
        std::vector<Diagnostic> all;
        try {
            load_campus(description, std::make_unique<collision::LinearBroadPhase>(), all, slow_at_first,
                        nullptr, concurrent);
        } catch (const InputError& error) {
            all.insert(all.end(), error.diagnostics().begin(), error.diagnostics().end());
        }
        return test::text_of(all);
    };
    EXPECT_EQ(reported(4, false), reported(1, false));
    EXPECT_EQ(reported(4, true), reported(1, true));
    EXPECT_NE(reported(4, true).find("m4 is broken"), std::string::npos);
}

}  // namespace
}  // namespace campuswalk::scene
