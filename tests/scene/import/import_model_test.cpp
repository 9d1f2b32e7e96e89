#include "scene/import/import_model.h"

#include <array>
#include <bit>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/scene/model_files.h"

namespace campuswalk::scene {
namespace {

using test::errors_of;
using test::has_code;
using test::scene_file;
using test::text_of;

class ImportModelTest : public testing::Test {
protected:
    Model import(const SceneFile& file, EmptyModel if_empty = EmptyModel::refuse) {
        ImportedModel imported = import_model(file, if_empty);
        warnings_ = std::move(imported.warnings);
        return std::move(imported.model);
    }
    Model import(const std::string& name) { return import(scene_file(folder_, name)); }
    std::vector<Diagnostic> errors(const std::string& name) {
        return errors_of([&] { import(name); });
    }
    /// Rewrites `from` as `to` in a file.
    void edit(const std::string& name, const std::string& from, const std::string& to) {
        std::stringstream text;
        text << std::ifstream(folder_.path() / name).rdbuf();
        std::string content = text.str();
        const std::size_t at = content.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        folder_.write(name, content.replace(at, from.size(), to));
    }

    test::TemporaryFolder folder_;
    std::vector<Diagnostic> warnings_;
};

TEST_F(ImportModelTest, KeepsNamesHierarchyAndTransforms) {
    test::write_gltf(
        folder_, "campus",
        {{.name = "campus"},
         {.name = "library", .X_parent_node = test::translation(10, 0, 0), .parent = 0},
         {.name = "walls", .size = {4, 2, 6}, .X_parent_node = test::translation(0, 1, 0), .parent = 1}});
    const Model model = import("campus.gltf");
    ASSERT_EQ(model.nodes.size(), 3U);
    EXPECT_EQ(model.nodes[0].name, "campus");
    EXPECT_EQ(model.nodes[1].name, "library");
    EXPECT_EQ(model.nodes[2].name, "walls");
    EXPECT_EQ(model.nodes[2].parent, 1);
    EXPECT_EQ(count_triangles(model), 12U);
    EXPECT_EQ(world_bounds(model).min, Eigen::Vector3d(8, 0, -3));
    EXPECT_EQ(world_bounds(model).max, Eigen::Vector3d(12, 2, 3));
    EXPECT_NEAR(test::signed_volume(model), 48.0, 1e-6);
    EXPECT_TRUE(warnings_.empty()) << text_of(warnings_);
}

TEST_F(ImportModelTest, GeneratesFlatNormalsForGltf) {
    test::write_gltf(folder_, "box", {{.name = "box", .size = {2, 2, 2}}});
    const Model model = import("box.gltf");
    const Mesh& mesh = model.meshes[0];
    ASSERT_EQ(mesh.positions.size(), 24U);
    ASSERT_EQ(mesh.normals.size(), 24U);
    for (std::size_t i = 0; i < 24; ++i) {
        EXPECT_FLOAT_EQ(mesh.normals[i].cwiseAbs().maxCoeff(), 1.0F);
        EXPECT_FLOAT_EQ(mesh.normals[i].dot(mesh.positions[i]), 1.0F);
    }
}

TEST_F(ImportModelTest, AppliesUpUnitScaleAndPosition) {
    folder_.write("box.obj", test::obj_box("box", {0, 0, 0}, {100, 200, 300}));
    SceneFile file = scene_file(folder_, "box.obj");
    file.up = UpAxis::z;
    file.metres_per_unit = 0.01;
    file.scale = 2.0;
    file.position = {10, 20, 30};
    const Model model = import(file);
    // 2 x 4 x 6 m, z up becomes y up: (x, y, z) goes to (x, z, -y).
    EXPECT_LT((world_bounds(model).min - Eigen::Vector3d(10, 20, 26)).norm(), 1e-9);
    EXPECT_LT((world_bounds(model).max - Eigen::Vector3d(12, 26, 30)).norm(), 1e-9);
    EXPECT_NEAR(test::signed_volume(model), 48.0, 1e-9);
}

TEST_F(ImportModelTest, CorrectsTheWindingOfMirroredNodes) {
    Eigen::Matrix4d mirror = Eigen::Matrix4d::Identity();
    mirror(0, 0) = -1.0;
    test::write_gltf(folder_, "pair", {{.name = "mirrored", .size = {1, 2, 3}, .X_parent_node = mirror}});
    EXPECT_NEAR(test::signed_volume(import("pair.gltf")), 6.0, 1e-6);

    // A mesh that an upright node uses, too, is copied and not flipped.
    test::write_gltf(folder_, "shared",
                     {{.name = "upright", .size = {1, 2, 3}},
                      {.name = "mirrored", .size = {1, 1, 1}, .X_parent_node = mirror}});
    edit("shared.gltf", "\"mesh\":1", "\"mesh\":0");
    const Model model = import("shared.gltf");
    EXPECT_EQ(model.meshes.size(), 2U);
    EXPECT_NEAR(test::signed_volume(model), 12.0, 1e-6);
}

TEST_F(ImportModelTest, IsDeterministic) {
    folder_.write("box.obj", test::obj_box("box", {0, 0, 0}, {1, 2, 3}));
    const Model first = import("box.obj");
    const Model second = import("box.obj");
    ASSERT_EQ(first.meshes.size(), second.meshes.size());
    EXPECT_EQ(first.meshes[0].positions, second.meshes[0].positions);
    EXPECT_EQ(first.meshes[0].normals, second.meshes[0].normals);
    EXPECT_EQ(first.meshes[0].triangles, second.meshes[0].triangles);
}

TEST_F(ImportModelTest, WeldsVerticesOfObjFiles) {
    folder_.write("box.obj", test::obj_box("box", {0, 0, 0}, {1, 2, 3}));
    EXPECT_EQ(import("box.obj").meshes[0].positions.size(), 24U);  // three normals at each of 8 firsts
}

TEST_F(ImportModelTest, TriangulatesPolygonsAndIgnoresLines) {
    folder_.write("face.obj", "o face\nv 0 0 0\nv 2 0 0\nv 2 0 1\nv 1 0 0.2\nv 0 0 1\nf 1 5 4 3 2\nl 1 2\n");
    EXPECT_EQ(count_triangles(import("face.obj")), 3U);
    EXPECT_TRUE(has_code(warnings_, "points-and-lines")) << text_of(warnings_);
}

TEST_F(ImportModelTest, AppliesFbxUnitsAndAxes) {
    const auto fbx = [](int up, int front, int front_sign, int unit) {
        std::ostringstream out;
        out << "; FBX 7.3.0 project file\nFBXHeaderExtension:  {\n FBXHeaderVersion: 1003\n FBXVersion: "
               "7300\n}\n"
            << "GlobalSettings:  {\n Version: 1000\n Properties70:  {\n"
            << "  P: \"UpAxis\", \"int\", \"Integer\", \"\"," << up << "\n"
            << "  P: \"UpAxisSign\", \"int\", \"Integer\", \"\",1\n"
            << "  P: \"FrontAxis\", \"int\", \"Integer\", \"\"," << front << "\n"
            << "  P: \"FrontAxisSign\", \"int\", \"Integer\", \"\"," << front_sign << "\n"
            << "  P: \"CoordAxis\", \"int\", \"Integer\", \"\",0\n"
            << "  P: \"CoordAxisSign\", \"int\", \"Integer\", \"\",1\n"
            << "  P: \"UnitScaleFactor\", \"double\", \"Number\", \"\"," << unit << "\n }\n}\n"
            << "Objects:  {\n Geometry: 1000, \"Geometry::tri\", \"Mesh\" {\n"
            << "  Vertices: *9 {\n   a: 0,0,0,100,0,0,0,0,200\n  }\n"
            << "  PolygonVertexIndex: *3 {\n   a: 0,1,-3\n  }\n  GeometryVersion: 124\n }\n"
            << " Model: 2000, \"Model::tri\", \"Mesh\" {\n  Version: 232\n }\n}\n"
            << "Connections:  {\n C: \"OO\",2000,0\n C: \"OO\",1000,2000\n}\n";
        return out.str();
    };
    folder_.write("y_cm.fbx", fbx(1, 2, 1, 1));
    EXPECT_LT((world_bounds(import("y_cm.fbx")).max - Eigen::Vector3d(1, 0, 2)).norm(), 1e-9);
    folder_.write("z_m.fbx", fbx(2, 1, -1, 100));
    EXPECT_LT((world_bounds(import("z_m.fbx")).max - Eigen::Vector3d(100, 200, 0)).norm(), 1e-9);
}

TEST_F(ImportModelTest, ReportsAMissingFileAtItsMark) {
    const auto found = errors("nowhere.gltf");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].code.text(), "missing-file");
    EXPECT_EQ(found[0].mark.file, "test.campus.yaml");
    EXPECT_EQ(found[0].mark.line, 3);
    EXPECT_TRUE(has_code(errors("."), "missing-file"));  // a folder
}

TEST_F(ImportModelTest, ReportsUnsupportedFormatsAndDamagedFiles) {
    folder_.write("broken.gltf", "{\"asset\":");
    const auto found = errors("broken.gltf");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].code.text(), "bad-model");
    EXPECT_EQ(found[0].message.find(folder_.path().string()), std::string::npos) << found[0].message;
    folder_.write("notes.xyz", "hello");
    EXPECT_TRUE(has_code(errors("notes.xyz"), "bad-model"));
    folder_.write("house.ifc", "ISO-10303-21;");
    EXPECT_NE(text_of(errors("house.ifc")).find("glTF"), std::string::npos);
}

TEST_F(ImportModelTest, RejectsAPlyFileTruncatedInItsHeader) {
    folder_.write("cut.ply", "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nelement face 1");
    EXPECT_NE(text_of(errors("cut.ply")).find("PLY header"), std::string::npos);
    const auto announcing = [&](const std::string& format, const std::string& faces,
                                const std::string& data) {
        folder_.write("few.ply", "ply\nformat " + format +
                                     " 1.0\ncomment x\nelement vertex 3\nproperty float x\nproperty float y\n"
                                     "property float z\nelement face " +
                                     faces + "\nproperty list uchar int vertex_indices\nend_header\n" + data);
        return text_of(errors("few.ply"));
    };
    const std::string text = "0 0 0\n1 0 0\n0 0 1\n3 0 1 2";  // and no end of the last line
    EXPECT_EQ(announcing("ascii", "1", text), "");
    for (const char* faces : {"20", "65536", "18446744073709551615", "99999999999999999999999"}) {
        EXPECT_NE(announcing("ascii", faces, text).find("its header announces"), std::string::npos) << faces;
    }
    for (const char* list : {"4 0 1 2\n", "65535 0 1 2", "4e9 0 1 2\n"}) {
        const std::string faces = text.substr(0, text.find("3 0 1")) + list;
        EXPECT_NE(announcing("ascii", "1", faces).find("more numbers than its line"), std::string::npos)
            << list;
    }
    EXPECT_EQ(announcing("ascii", "2", text + " 9\r\n 4\t0 1 2 1 \r\n"), "");
    std::string binary(36, '\0');
    binary[14] = '\x80';  // x of the second vertex is 1, z of the third
    binary[15] = '\x3F';
    binary[34] = '\x80';
    binary[35] = '\x3F';
    binary += std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
    EXPECT_EQ(announcing("binary_little_endian", "1", binary), "");
    EXPECT_NE(announcing("binary_little_endian", "14", binary).find("its header announces"),
              std::string::npos);
}

/// A box of 4 m by 3 m by 2 m whose elements are preceded, divided and followed by others; its first vertex
/// is at `first`, a position near (0, 0, 0).
std::string odd_ply(bool is_text, const std::array<float, 3>& first) {
    std::string ply =
        std::string("ply\nformat ") + (is_text ? "ascii" : "binary_little_endian") +
        " 1.0\ncomment made by hand\nelement camera 2\nproperty list uchar short view\n"
        "property float x\nelement vertex 8\ncomment Points\nproperty float x\nproperty float y\n"
        "comment TextureFile none.png\nproperty float z\nobj_info a\nelement edge 1\n"
        "property int vertex1\ncomment\nelement face 6\nproperty list uchar int vertex_indices\n"
        "element end 1\nproperty char end\nend_header\n";
    const auto put = [&](auto value) {
        if (is_text) {
            std::ostringstream text;
            text << +value << ' ';
            ply += text.str();
        } else {
            const auto bytes = std::bit_cast<std::array<char, sizeof value>>(value);
            ply.append(bytes.begin(), bytes.end());
        }
    };
    const auto end_line = [&] { ply += is_text ? "\n" : ""; };
    for (const int length : {2, 0}) {
        put(static_cast<std::uint8_t>(length));
        for (int i = 0; i < length; ++i) {
            put(static_cast<std::int16_t>(0x0A0A));
        }
        put(1.5F);
        end_line();
    }
    for (int i = 0; i < 8; ++i) {
        put(i == 0 ? first[0] : i % 4 == 1 || i % 4 == 2 ? 4.0F : 0.0F);
        put(i == 0 ? first[1] : i % 4 >= 2 ? 3.0F : 0.0F);
        put(i == 0 ? first[2] : i >= 4 ? 2.0F : 0.0F);
        end_line();
    }
    put(std::int32_t{7});
    end_line();
    for (const auto& face : std::array<std::array<std::int32_t, 4>, 6>{
             {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 4, 7, 3}, {1, 2, 6, 5}}}) {
        put(std::uint8_t{4});
        for (const std::int32_t index : face) {
            put(index);
        }
        end_line();
    }
    put(std::int8_t{1});
    end_line();
    return ply;
}

TEST_F(ImportModelTest, TakesPlyFilesWithOtherElementsCommentsAndLineEndsInData) {
    // Begins with the bytes of line ends.
    const float line_ends = std::bit_cast<float>(std::array<char, 4>{'\n', '\n', '\r', '\0'});
    for (const bool is_text : {true, false}) {
        for (const float x : {0.0F, line_ends}) {
            const std::string whole = odd_ply(is_text, {x, 0.0F, 0.0F});
            std::string plain = whole;  // begins with the vertices
            const std::size_t camera = plain.find("element camera");
            plain.erase(camera, plain.find("element vertex") - camera);
            std::size_t data = plain.find("end_header\n") + 11;
            plain.erase(data, is_text ? plain.find('\n', plain.find('\n', data) + 1) + 1 - data : 14);
            for (const std::string& text : {whole, plain}) {
                folder_.write("odd.ply", text);
                const Model model = import("odd.ply");
                EXPECT_EQ(count_triangles(model), 12U) << is_text;
                EXPECT_NEAR(test::signed_volume(model), 24.0, 1e-4) << is_text;
            }
        }
    }
}

TEST_F(ImportModelTest, RejectsPlyElementsWithoutPropertiesThatTheFileCantHold) {
    for (const char* format : {"ascii", "binary_little_endian"}) {
        folder_.write("many.ply",
                      std::string("ply\nformat ") + format + " 1.0\nelement vertex 4000000000\nend_header\n");
        EXPECT_NE(text_of(errors("many.ply")).find("its header announces"), std::string::npos) << format;
    }
    folder_.write("word.ply", "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nend_headers\n");
    EXPECT_NE(text_of(errors("word.ply")).find("inside its PLY header"), std::string::npos);
}

TEST_F(ImportModelTest, ReadsNoBufferOutsideOfTheSceneFolder) {
    test::TemporaryFolder outside;
    test::write_gltf(folder_, "box", {{.name = "box", .size = {1, 1, 1}}});
    ASSERT_EQ(count_triangles(import("box.gltf")), 12U);
    std::filesystem::rename(folder_.path() / "box.bin", outside.path() / "box.bin");
    const std::string absolute = (outside.path() / "box.bin").string();
    const std::string climbing = "../" + outside.path().filename().string() + "/box.bin";
    edit("box.gltf", "box.bin", absolute);
    EXPECT_TRUE(has_code(errors("box.gltf"), "bad-model"));
    edit("box.gltf", absolute, climbing);
    EXPECT_TRUE(has_code(errors("box.gltf"), "bad-model"));
    edit("box.gltf", climbing, "sub%20folder/box.bin");
    std::filesystem::create_directory(folder_.path() / "sub folder");
    std::filesystem::rename(outside.path() / "box.bin", folder_.path() / "sub folder/box.bin");
    EXPECT_EQ(count_triangles(import("box.gltf")), 12U);
}

TEST_F(ImportModelTest, RejectsAnEmptyModelUnlessAccepted) {
    test::write_gltf(folder_, "empty", {{.name = "nothing"}});
    EXPECT_TRUE(has_code(errors("empty.gltf"), "empty-mesh"));
    const Model model = import(scene_file(folder_, "empty.gltf"), EmptyModel::accept);
    EXPECT_EQ(model.nodes.size(), 1U);
    EXPECT_TRUE(model.meshes.empty());
}

TEST_F(ImportModelTest, NamesNodesWithBadVertices) {
    const std::string good = test::obj_box("good", {0, 0, 0}, {1, 1, 1});
    folder_.write("nan.obj", good + "o bad_tree\nv nan 0 0\nv 1 0 0\nv 0 1 0\nf 9 10 11\n" +
                                 "o bad_wall\nv 0 0 0\nv 1 inf 0\nv 0 1 0\nf 12 13 14\n");
    const auto found = errors("nan.obj");
    ASSERT_EQ(found.size(), 2U) << text_of(found);
    EXPECT_EQ(found[0].code.text(), "bad-vertex");
    EXPECT_NE(found[0].message.find("bad_tree"), std::string::npos);
    EXPECT_NE(found[1].message.find("bad_wall"), std::string::npos);
}

TEST_F(ImportModelTest, IgnoresUnusedBadVertices) {
    folder_.write("spare.obj", "v nan nan nan\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\n");
    const Model model = import("spare.obj");
    EXPECT_EQ(world_bounds(model).max, Eigen::Vector3d(1, 1, 0));
}

TEST_F(ImportModelTest, ReportsAllErrorsTogether) {
    folder_.write("two.obj",
                  "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 0 inf 0\n"
                  "o a\nf 1 2 3\no b\nf 1 2 5\no c\nf 1 2 4\n");
    const auto found = errors("two.obj");
    EXPECT_EQ(found.size(), 2U) << text_of(found);
    EXPECT_TRUE(has_code(found, "bad-vertex"));
}

TEST_F(ImportModelTest, WarnsAboutAMissingMaterialFile) {
    folder_.write("plain.obj", "mtllib gone.mtl\n" + test::obj_box("box", {0, 0, 0}, {1, 1, 1}));
    EXPECT_EQ(count_triangles(import("plain.obj")), 12U);
    EXPECT_TRUE(has_code(warnings_, "missing-materials")) << text_of(warnings_);
}

/// A triangle, with this before its numbers.
std::string collada(const std::string& space) {
    return "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
           "version=\"1.4.1\"><asset><unit meter=\"1\"/><up_axis>Y_UP</up_axis></asset>\n"
           "<library_effects><effect id=\"e\"><profile_COMMON><technique "
           "sid=\"t\"><phong><diffuse><color>" +
           space + "1 0 0 1</color></diffuse><shininess><float>" + space +
           "20</float></shininess></phong></technique></profile_COMMON></effect></library_effects>\n"
           "<library_materials><material id=\"m\" name=\"red\"><instance_effect url=\"#e\"/></material>"
           "</library_materials><library_geometries><geometry id=\"g\"><mesh><source id=\"s\">"
           "<float_array id=\"a\" count=\"9\">" +
           space +
           "0 0 0 0 0 1 1 0 0</float_array><technique_common><accessor source=\"#a\" count=\"3\" "
           "stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/><param "
           "name=\"Z\" "
           "type=\"float\"/></accessor></technique_common></source><vertices id=\"v\"><input "
           "semantic=\"POSITION\" source=\"#s\"/></vertices><triangles count=\"1\" material=\"m\"><input "
           "semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>" +
           space +
           "0 1 2</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>"
           "<visual_scene id=\"vs\"><node id=\"n\" name=\"floor\"><instance_geometry url=\"#g\">"
           "<bind_material><technique_common><instance_material symbol=\"m\" "
           "target=\"#m\"/></technique_common>"
           "</bind_material></instance_geometry></node></visual_scene></library_visual_scenes>"
           "<scene><instance_visual_scene url=\"#vs\"/></scene></COLLADA>";
}

TEST_F(ImportModelTest, ReadsColladaNumbersAfterWhiteSpace) {
    for (const char* space : {"", " ", "\n\t  "}) {
        folder_.write("floor.dae", collada(space));
        const Model model = import("floor.dae");
        EXPECT_EQ(count_triangles(model), 1U);
        EXPECT_EQ(match_nodes(model, "floor").size(), 1U);
        EXPECT_FLOAT_EQ(model.materials[index_of(model.meshes[0].material)].base_color[0], 1.0F);
    }
}

TEST_F(ImportModelTest, RefusesColladaWhoseNumbersDontFit) {
    const auto refusal_of = [&](const std::string& from, const std::string& to) {
        folder_.write("floor.dae", collada(""));
        edit("floor.dae", from, to);
        return text_of(errors("floor.dae"));
    };
    const std::string range = "the accessor of source '#s' reaches beyond its array of numbers";
    struct Change {
        std::string from;
        std::string to;
        std::string message;
    };
    const std::vector<Change> changes = {
        {"<p>0 1 2", "<p>0 1\x01 2", "the <p> of a <triangles> holds something else"},
        {"count=\"9\"", "count=\"8\"", range},
        {"count=\"9\"", "", range},
        {"accessor source=\"#a\" count=\"3\"", "accessor source=\"#a\" count=\"-1\"", range},
        {"stride=\"3\"", "stride=\"3\" offset=\"1\"", range},
        {"stride=\"3\"", "stride=\"4000000000\"", range},
        {"semantic=\"VERTEX\"", "semantic=\"NORMAL\"",
         "a <triangles> lacks an input with the semantic VERTEX"}};
    for (const auto& [from, to, message] : changes) {
        const std::string found = refusal_of(from, to);
        EXPECT_NE(found.find(message), std::string::npos) << to << ": " << found;
        EXPECT_NE(found.find("bad-model"), std::string::npos) << to << ": " << found;
    }
    folder_.write("floor.dae", collada(""));
    edit("floor.dae", "<float_array", "<Name_array");
    edit("floor.dae", "</float_array", "</Name_array");
    EXPECT_NE(text_of(errors("floor.dae")).find(range), std::string::npos);
    folder_.write("floor.dae", collada(""));
    edit("floor.dae", "<triangles", "<polylist");
    edit("floor.dae", "</triangles", "</polylist");
    EXPECT_NE(text_of(errors("floor.dae")).find("a <polylist> lacks <vcount>"), std::string::npos);
    edit("floor.dae", "<p>", "<vcount>3</vcount><p>");
    EXPECT_EQ(count_triangles(import("floor.dae")), 1U);
    edit("floor.dae", "<polylist", "<polygons");
    edit("floor.dae", "</polylist", "</polygons");
    edit("floor.dae", "<vcount>3</vcount><p>0 1 2</p>", "<ph><p>0 1 2</p><h>0 1 2</h></ph>");
    const std::string holes = text_of(errors("floor.dae"));
    EXPECT_NE(
        holes.find(
            "a <polygons> has holes (<ph>), which aren't read: have the exporter triangulate all faces"),
        std::string::npos)
        << holes;
}

}  // namespace
}  // namespace campuswalk::scene
