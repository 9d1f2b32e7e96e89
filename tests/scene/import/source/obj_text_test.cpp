#include "scene/import/source/obj_text.h"

#include <string>
#include <string_view>

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

}  // namespace
}  // namespace campuswalk::scene
