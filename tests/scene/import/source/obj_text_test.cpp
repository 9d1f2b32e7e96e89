#include "scene/import/source/obj_text.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "scene/import/import_model.h"
#include "tests/scene/model_files.h"

namespace campuswalk::scene {
namespace {

struct Moved {
    std::string text;
    Eigen::Vector3d origin;
};

Moved moved(std::string_view text, double metres_per_unit = 1.0) {
    std::vector<std::uint8_t> bytes(text.begin(), text.end());
    const Eigen::Vector3d origin = move_vertices_near(bytes, metres_per_unit);
    return {std::string(bytes.begin(), bytes.end()), origin};
}

TEST(ObjText, MovesMapCoordinatesNearTheOrigin) {
    const Moved far = moved(
        "# Delft\nv 85012.343 447455.577 0.88\nvn 0 0 1\n  v +85010.343 447457.577 0.88 0.1 0.2 0.3\r\nf 1 2 "
        "1\n");
    EXPECT_EQ(far.origin, Eigen::Vector3d(85011, 447457, 1));
    EXPECT_EQ(far.text,
              "# Delft\nv 1.343 -1.423 -0.12\nvn 0 0 1\nv -0.657 0.577 -0.12 0.1 0.2 0.3\r\nf 1 2 1\n");
}

TEST(ObjText, KeepsNearWideOrUnusualVertices) {
    for (const std::string text : {
             "v 1 2 3\nv 4 5 6\n",                        // near
             "v 85012 447455 1\nv 0 0 0\n",               // one is near
             "v -85012 447455 1\nv 85012 -447455 1\n",    // as large as it is far
             "v 85012 447455 nan\nv 85012 447456 1\n",    // no number
             "v 85012 447455\nv 85012 447456 1\n",        // two numbers
             "v 85012 447455 1 2\nv 85012 447456 1 2\n",  // weights
             "v 85012 447455 \\\n1\nv 85012 447456 1\n",  // continues in the next line
             "v 85012 447455 1x\nv 85012 447456 1\n",     // more than a number
             "v 1e999 447455 1\nv 85012 447456 1\n",      // out of range
             "vt 85012 447455\nvn 85012 447455 1\n",
             "v",
             "v ",
             "",
         }) {
        EXPECT_EQ(moved(text).text, text);
        EXPECT_EQ(moved(text).origin, Eigen::Vector3d::Zero()) << text;
    }
    EXPECT_NE(moved("v 85012 447455 1 1.0\nv 85012 447456 1 1.0").origin, Eigen::Vector3d::Zero());
}

/// The limit is in metres, whatever the unit.
TEST(ObjText, MeasuresPrecisionInMetres) {
    const std::string text = "v 85012.343 447455.577 0.88\nv 85012.443 447455.577 0.88\n";
    EXPECT_EQ(moved(text, 0.001).origin, Eigen::Vector3d::Zero());
    EXPECT_NE(moved(text, 0.1).origin, Eigen::Vector3d::Zero());
}

std::string normalized(std::string_view text) {
    std::vector<std::uint8_t> bytes(text.begin(), text.end());
    const std::string fault = normalize_obj(bytes);
    return fault.empty() ? std::string(bytes.begin(), bytes.end()) : fault;
}

TEST(ObjText, NormalizesWhatAssimpMisreads) {
    for (const auto& [text, expected] : std::vector<std::pair<std::string, std::string>>{
             {"\xEF\xBB\xBFv 0 0 0", "v 0 0 0\n"},
             {"v .5 -.5 +.5\nv 5. 1e3 -1.5E-3\n", "v 0.5 -.5 +.5\nv 5. 1e3 -1.5E-3\n"},
             {"vt .5\nvt .5 .5\nvt 0 1 0 7\nvn .0 1 .0\n", "vt 0.5 0\nvt 0.5 0.5\nvt 0 1 0\nvn 0.0 1 0.0\n"},
             {"v nan inf 1\n", "v nan inf 1\n"},
             {"v 0 0 0 # 1\nf 1 2 3# 4\nl 1 2 #\n#f 1 2 3\n", "v 0 0 0\nf 1 2 3\nl 1 2 \n"},
             {"  v\t1  2 3 \r\n\n\tf 1 2 3\r\n", "v 1 2 3\nf 1 2 3\n"},
             {"v 0 0 0\rf 1 2 3\r", "v 0 0 0\nf 1 2 3\n"},
             {"v 0 0 0 2\nv 0 0 0 2 2\nv 0 0 0 1 1 1\nv 0 0 0 1 1 1 1\nv 0 0 0 x\n",
              "v 0 0 0 2\nv 0 0 0\nv 0 0 0 1 1 1\nv 0 0 0 1 1 1\nv 0 0 0\n"},
             {"v 1 2 \\\n3\nf 1 \\\r\n 2 3\n# C:\\\nv 1 2 3 # C:\\\nv 4 5 6\n",
              "v 1 2 3\nf 1   2 3\nv 1 2 3\nv 4 5 6\n"},
             {"o Main Hall \nf 1\no Main  Gate #2\no Main  Gate #2\n",
              "g Main Hall\x1F"
              "0\nf 1\ng Main  Gate #2\x1F"
              "1\n"},
             {"o floor # the floor\nusemtl red # paint\n",
              "g floor\x1F"
              "0\nusemtl red\n"},
             {"o a\ng\no\ng a\ng b\ng\n",
              "g a\x1F"
              "0\ng b\x1F"
              "1\ng \x1F"
              "2\n"},
             {"usemtl Red #2\nmtllib a b.mtl\ns off # all\ncurv 0\n",
              "usemtl Red #2\nmtllib a b.mtl\ns off \ncurv 0\n"},
             {"v 0 0 0\n\nv 0 \\\n1\n", "line 4 has a vertex without three numbers"},
             {"v 0 zero 0\n", "line 1 has a vertex without three numbers"},
             {"v 0 - 0\n", "line 1 has a vertex without three numbers"},
             {std::string("\xFF\xFEv\0", 4), "it is UTF-16, and OBJ files are UTF-8"},
             {"", ""},
         }) {
        EXPECT_EQ(normalized(text), expected) << text;
    }
}

class ObjFile : public testing::Test {
protected:
    ImportedModel import(const std::string& text) {
        folder_.write("a.obj", text);
        return import_model(test::scene_file(folder_, "a.obj"));
    }
    /// "NAME TRIANGLES" of each node with a mesh.
    std::vector<std::string> nodes(const std::string& text) {
        const Model model = import(text).model;
        std::vector<std::string> result;
        for (const Node& node : model.nodes) {
            std::size_t triangles = 0;
            for (const MeshIndex mesh : node.meshes) {
                triangles += model.meshes[index_of(mesh)].triangles.size();
            }
            if (triangles > 0) {
                result.push_back(node.name + " " + std::to_string(triangles));
            }
        }
        return result;
    }

    test::TemporaryFolder folder_;
};

const std::string kVertices = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 1 0\nv 1 1 0\n";

TEST_F(ObjFile, GivesFacesToTheObjectNamed) {
    using Names = std::vector<std::string>;
    EXPECT_EQ(nodes(kVertices + "o a\nf 1 2 3\no b\nf 1 2 5\no a\nf 1 3 4\nf 2 5 6\n"),
              (Names{"a 3", "b 1"}));
    EXPECT_EQ(nodes(kVertices + "g a\nf 1 2 3\no b\nf 1 2 5\ng a\nf 1 3 4\n"), (Names{"a 2", "b 1"}));
    EXPECT_EQ(nodes(kVertices +
                    "o a\nusemtl m\nf 1 2 3\nusemtl n\nf 1 2 5\no b\nf 1 2 6\no a\nusemtl m\nf 1 3 4\n"),
              (Names{"a 3", "b 1"}));
    EXPECT_EQ(nodes(kVertices + "o Main Hall\nf 1 2 3\no Main Gate\nf 1 2 5\ng Main Wall\nf 1 5 4\n"),
              (Names{"Main Hall 1", "Main Gate 1", "Main Wall 1"}));
}

TEST_F(ObjFile, ReadsVerticesWithoutALeadingZeroAndComments) {
    const std::string text =
        "\xEF\xBB\xBFo floor\nv 0 .5 0 # 1\nv 1. .5 0\nv +1 .5 1\nv 0 .5 10e-1 # 4 5\nf 1 2 3 4 # all\n";
    EXPECT_EQ(nodes(text), (std::vector<std::string>{"floor 2"}));
    const Bounds bounds = world_bounds(import(text).model);
    EXPECT_EQ(bounds.min, Eigen::Vector3d(0, 0.5, 0));
    EXPECT_EQ(bounds.max, Eigen::Vector3d(1, 0.5, 1));
}

TEST_F(ObjFile, IsRefusedWithTheLineOfAFaultyVertex) {
    const auto errors = test::errors_of([&] { import("o a\nv 1 2\nf 1 1 1\n"); });
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].code.text(), "bad-model");
    EXPECT_NE(errors[0].message.find("line 2 has a vertex without three numbers"), std::string::npos);
}

TEST(ObjText, DropsReferencesToMissingTextureCoordinates) {
    const auto dropped = [](std::string_view text) {
        std::vector<std::uint8_t> bytes(text.begin(), text.end());
        const bool changed = drop_absent_uvs(bytes);
        EXPECT_EQ(changed,
                  std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()) != text);
        return std::string(bytes.begin(), bytes.end());
    };
    EXPECT_EQ(dropped("v 1 2 3\n  f 1/1/1 20/30/40\t3//4 5\r\ng a/b/c\nf -1/-1 2\n"),
              "v 1 2 3\n  f 1//1 20//40\t3//4 5\r\ng a/b/c\nf -1 2\n");
    for (const std::string text : {"vt 0 0\nf 1/1/1 2/1/1 3/1/1\n", "f 1/1 2/1 3/1\n vt 0 0\n",
                                   "f 1//1 2//1 3//1\n", "f 1 2 3\n", "f", ""}) {
        EXPECT_EQ(dropped(text), text);
    }
}

TEST(ObjText, ImportsFacesWithMissingTextureCoordinates) {
    const test::TemporaryFolder folder;
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1\n");
    const ImportedModel imported = import_model(test::scene_file(folder, "a.obj"));
    EXPECT_EQ(count_triangles(imported.model), 1U);
    EXPECT_TRUE(test::has_code(imported.warnings, "repaired-uvs"));
}

TEST(ObjText, KeepsMillimetresFarFromTheOrigin) {
    const test::TemporaryFolder folder;
    folder.write("far.obj",
                 "o house\nv 85012.343 447455.577 1.251\nv 85013.344 447455.577 1.251\n"
                 "v 85013.344 447456.578 2.252\nf 1 2 3\n");
    SceneFile file = test::scene_file(folder, "far.obj");
    file.up = UpAxis::z;
    const Bounds far = world_bounds(import_model(file).model);
    EXPECT_LT((far.min - Eigen::Vector3d(85012.343, 1.251, -447456.578)).norm(), 1e-6) << far.min.transpose();
    EXPECT_LT((far.max - Eigen::Vector3d(85013.344, 2.252, -447455.577)).norm(), 1e-6) << far.max.transpose();
    file.position = {-85012, 0, 447456};
    const Bounds near = world_bounds(import_model(file).model);
    EXPECT_LT((near.min - Eigen::Vector3d(0.343, 1.251, -0.578)).norm(), 1e-6) << near.min.transpose();
}

TEST(ObjText, NamesAreInNormalizationFormCOrReported) {
    test::TemporaryFolder folder;
    const auto text = [](const std::string& name) {
        return "o " + name + "\nv 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n";
    };
    folder.write("nfd.obj", text("e\u0301cole"));
    const ImportedModel composed = import_model(test::scene_file(folder, "nfd.obj"));
    EXPECT_EQ(match_nodes(composed.model, "\u00e9cole").size(), 1U);
    EXPECT_FALSE(test::has_code(composed.warnings, "bad-encoding"));
    folder.write("latin1.obj", text("B\xe2timent"));
    const ImportedModel latin = import_model(test::scene_file(folder, "latin1.obj"));
    ASSERT_TRUE(test::has_code(latin.warnings, "bad-encoding"));
    EXPECT_EQ(match_nodes(latin.model, "B?timent").size(), 1U);
}

}  // namespace
}  // namespace campuswalk::scene
