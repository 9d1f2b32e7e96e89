// Models far from their file's origin, and the geographic locations of files.

#include <gtest/gtest.h>

#include "scene/cache/load_model.h"
#include "scene/campus/campus.h"
#include "scene/import/helper/import_process.h"
#include "scene/import/import_model.h"
#include "tests/scene/import/gltf/gltf_text.h"
#include "tests/scene/model_files.h"
#include "tests/support/angles.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;
using test::GltfText;

constexpr double kMicrometre = 1e-6;

class FarModels : public testing::Test {
protected:
    void SetUp() override { place("far.glb", {{"translation", {84512.123456, 1.5, -447321.654321}}}); }

    /// A triangle of 1 m on a node.
    void place(const std::string& name, test::Json node, const test::Json& extensions = {}) {
        GltfText text;
        node["mesh"] = text.add_triangle_mesh();
        node["name"] = "floor";
        text.add_node(node);
        if (!extensions.empty()) {
            text.json["extensions"] = extensions;
            text.json["extensionsUsed"] = {"CESIUM_RTC"};
            text.json["extensionsRequired"] = {"CESIUM_RTC"};
        }
        text.write_glb(folder_, name);
    }
    void place_about(const std::string& name, const test::Json& center) {
        place(name, test::Json::object(), {{"CESIUM_RTC", {{"center", center}}}});
    }
    Model import(const SceneFile& file) {
        ImportedModel imported = import_model(file);
        warnings_ = std::move(imported.warnings);
        return std::move(imported.model);
    }
    Model import(const std::string& name) { return import(test::scene_file(folder_, name)); }
    Campus campus(const std::string& name, const CampusOrigin& origin, const CacheFolder* cache = nullptr) {
        CampusDescription description;
        description.scenes = {test::scene_file(folder_, name)};
        description.origin = origin;
        ColliderDescription all;
        all.id = "all";
        all.shape = MeshShape{};
        all.nodes = {{{}, "*"}};
        all.modes.solid = true;
        description.colliders = {all};
        return load_campus(description, std::make_unique<collision::LinearBroadPhase>(), warnings_,
                           import_model, cache);
    }

    test::TemporaryFolder folder_;
    std::vector<Diagnostic> warnings_;
};

Vector3d place_of(const Model& model) {
    return model.nodes.back().X_world_node.topRightCorner<3, 1>();
}

TEST_F(FarModels, KeepMicrometres) {
    const Vector3d written(84512.123456, 1.5, -447321.654321);
    EXPECT_LT((place_of(import("far.glb")) - written).norm(), kMicrometre);
    place("matrix.glb",
          {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 84512.123456, 1.5, -447321.654321, 1}}});
    EXPECT_LT((place_of(import("matrix.glb")) - written).norm(), kMicrometre);
}

TEST_F(FarModels, RoundTripBitExactlyThroughHelperAndCache) {
    const SceneFile file = test::scene_file(folder_, "far.glb");
    const Vector3d here = place_of(import("far.glb"));
    const Importer in_helper = import_in_process({ODD_IMPORT_HELPER, {"serve"}});
    EXPECT_EQ(place_of(in_helper(file, EmptyModel::refuse).model), here);
    const CacheFolder cache(folder_.path() / "cache");
    for (int time = 0; time < 2; ++time) {
        EXPECT_EQ(place_of(load_model(file, EmptyModel::refuse, import_model, &cache).imported.model), here);
    }
}

TEST_F(FarModels, KeepTheirOriginByDefault) {
    const Campus there = campus("far.glb", {});
    EXPECT_FALSE(there.origin.is_known());
    EXPECT_LT((place_of(there.models[0]) - Vector3d(84512.123456, 1.5, -447321.654321)).norm(), kMicrometre);
}

TEST_F(FarModels, MoveNearTheOriginOnRequest) {
    const CacheFolder cache(folder_.path() / "cache");
    for (const CacheFolder* cache_or_none : {static_cast<const CacheFolder*>(nullptr), &cache, &cache}) {
        const Campus there = campus("far.glb", {}, cache_or_none);
        const Campus near = campus("far.glb", {.near = true, .origin = {}}, cache_or_none);
        EXPECT_EQ(near.origin.at, Vector3d(85000, 0, -447000));
        EXPECT_LT((place_of(near.models[0]) - Vector3d(-487.876544, 1.5, -321.654321)).norm(), kMicrometre);
        const auto world = [](const Campus& campus) {
            return campus.world.object(collision::ObjectId{0}).X_world_shape.translation;
        };
        EXPECT_LT((world(near) + near.origin.at - world(there)).norm(), 1.1e-3);  // about whole millimetres
        EXPECT_LT(world(near).norm(), 1e3);
    }
    const Campus given = campus("far.glb", {.near = false, .origin = {{84512, 0, -447322}, {}}});
    EXPECT_LT((place_of(given.models[0]) - Vector3d(0.123456, 1.5, 0.345679)).norm(), kMicrometre);
}

TEST_F(FarModels, NearModelsStayInPlace) {
    place("near.glb", {{"translation", {9000, 0, -20}}});
    EXPECT_FALSE(campus("near.glb", {.near = true, .origin = {}}).origin.is_known());
}

TEST_F(FarModels, AreRefusedBeyondAnyDistance) {
    place("planet.glb", {{"scale", {9e10, 1, 1}}});
    EXPECT_NO_THROW(import("planet.glb"));
    for (const double scale : {2e11, 1e307, -1e300}) {
        place("vast.glb", {{"scale", {1, 1, scale}}});
        EXPECT_TRUE(test::has_code(test::errors_of([&] { import("vast.glb"); }), "bad-size")) << scale;
    }
    place("skewed.glb", {{"matrix", {1, 1e300, 0, 0, 0, -1e300, 0, 0, 0, 0, 1, 0, 0, 1e300, 0, 1}}});
    EXPECT_TRUE(test::has_code(test::errors_of([&] { import("skewed.glb"); }), "bad-size"));
    place("remote.glb", {{"translation", {0, 1e12, 0}}});
    EXPECT_TRUE(test::has_code(test::errors_of([&] { import("remote.glb"); }), "bad-size"));
}

// Latitude 52, longitude 4.375, 10 m up, by WGS 84's formula (see tangent_frame_test.cpp), to 0.01 mm.
const test::Json kDelft = {3923500.65116, 300174.89356, 5002811.22559};

TEST_F(FarModels, UseTheTangentFrameOfAnEcefCenter) {
    place_about("tile.glb", kDelft);
    const Model model = import("tile.glb");
    EXPECT_EQ(test::text_of(warnings_), "");
    ASSERT_TRUE(model.geographic);
    EXPECT_EQ(model.geographic->at, Vector3d(0, 0, 0));
    EXPECT_NEAR(model.geographic->latitude_deg, 52.0, 1e-9);
    EXPECT_NEAR(model.geographic->longitude_deg, 4.375, 1e-9);
    EXPECT_NEAR(model.geographic->height, 10.0, 1e-4);
    // The file's axes are ECEF, converted to Y-up: +Y points to the north pole.
    const Vector3d pole = model.nodes.back().X_world_node.topLeftCorner<3, 3>() * Vector3d::UnitY();
    const double latitude = support::radians(model.geographic->latitude_deg);
    EXPECT_LT((pole - Vector3d(0, std::sin(latitude), -std::cos(latitude))).norm(), 1e-12);
    EXPECT_EQ(place_of(model), Vector3d(0, 0, 0));
    EXPECT_EQ(campus("tile.glb", {}).origin.geographic, model.geographic);
}

TEST_F(FarModels, AreTranslatedByACenterInMapCoordinates) {
    place_about("map.glb", {84512.123456, 447321.654321, 3.5});
    const Model model = import("map.glb");
    EXPECT_FALSE(model.geographic);
    EXPECT_LT((place_of(model) - Vector3d(84512.123456, 3.5, -447321.654321)).norm(), kMicrometre);
    place_about("none.glb", nullptr);
    const std::string refusal = test::text_of(test::errors_of([&] { import("none.glb"); }));
    EXPECT_NE(refusal.find("extensions/CESIUM_RTC"), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("'center'"), std::string::npos) << refusal;
}

std::string collada_at(const std::string& location) {
    return "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
           "version=\"1.4.1\"><asset><coverage>" +
           location +
           "</coverage><unit meter=\"1\"/><up_axis>Y_UP</up_axis></asset><library_geometries><geometry "
           "id=\"g\">"
           "<mesh><source id=\"s\"><float_array id=\"a\" count=\"9\">0 0 0 0 0 1 1 0 0</float_array>"
           "<technique_common><accessor source=\"#a\" count=\"3\" stride=\"3\"><param name=\"X\" "
           "type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/></accessor>"
           "</technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#s\"/>"
           "</vertices><triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
           "<p>0 1 2</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>"
           "<visual_scene id=\"vs\"><node id=\"n\"><instance_geometry url=\"#g\"/></node></visual_scene>"
           "</library_visual_scenes><scene><instance_visual_scene url=\"#vs\"/></scene></COLLADA>";
}

TEST_F(FarModels, ReadTheGeographicLocationOfCollada) {
    folder_.write("a.dae",
                  collada_at("<geographic_location><longitude> -105.283 </longitude>\n<latitude>40.017"
                             "</latitude><altitude mode=\"absolute\">1655.5</altitude>"
                             "</geographic_location>"));
    SceneFile file = test::scene_file(folder_, "a.dae");
    file.position = {10, 0, -20};
    const Model model = import(file);
    EXPECT_EQ(test::text_of(warnings_), "");
    EXPECT_EQ(model.geographic, (GeographicPlace{40.017, -105.283, 1655.5, {10, 0, -20}}));
    // The campus file overrides the model; its location is that of the campus origin.
    const GeographicPlace given = {1.0, 2.0, 3.0, {0, 0, 0}};
    EXPECT_EQ(campus("a.dae", {.near = false, .origin = {{5, 0, 0}, given}}).origin.geographic, given);
    EXPECT_EQ(campus("a.dae", {.near = false, .origin = {{5, 0, 0}, {}}}).origin.geographic->at,
              Vector3d(-5, 0, 0));
}

TEST_F(FarModels, RejectInvalidGeographicLocationsOfCollada) {
    for (const char* location :
         {"<geographic_location><longitude>4</longitude><latitude>91</latitude></geographic_location>",
          "<geographic_location><longitude>-180.5</longitude><latitude>9</latitude></geographic_location>",
          "<geographic_location><longitude>4</longitude></geographic_location>",
          "<geographic_location><longitude>4 5</longitude><latitude>9</latitude></geographic_location>",
          "<geographic_location><longitude>nan</longitude><latitude>9</latitude></geographic_location>"}) {
        folder_.write("a.dae", collada_at(location));
        warnings_.clear();
        EXPECT_FALSE(import("a.dae").geographic) << location;
        EXPECT_TRUE(test::has_code(warnings_, "bad-geography")) << location;
    }
    for (const char* nothing :
         {"",
          "<!-- <geographic_location><longitude>4</longitude><latitude>9</latitude></geographic_location> "
          "-->"}) {
        folder_.write("a.dae", collada_at(nothing));
        warnings_.clear();
        EXPECT_FALSE(import("a.dae").geographic) << nothing;
        EXPECT_TRUE(warnings_.empty()) << nothing;
    }
}

}  // namespace
}  // namespace campuswalk::scene
