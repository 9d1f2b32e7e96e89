#include "scene/import/source/scene_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scene/model_files.h"

namespace campuswalk::scene {
namespace {

namespace fs = std::filesystem;

using testing::Contains;
using testing::Not;
using testing::Property;

class SceneFolderTest : public testing::Test {
protected:
    void SetUp() override {
        for (const char* name :
             {"model/meshes/scene.gltf", "model/meshes/a b.bin", "model/meshes/deep/er/x.bin",
              "model/meshes/textures/own.png", "model/materials/textures/wood.png",
              "model/Textures/stone.png", "model/private/secret.png", "model/secret.bin", "outside.bin"}) {
            files_.write(name, "x");
        }
    }

    SceneFile scene() const {
        SceneFile file;
        file.path = files_.path() / "model/meshes/scene.gltf";
        return file;
    }
    SceneFolder folder() const { return SceneFolder(scene()); }

    test::TemporaryFolder files_;
};

TEST_F(SceneFolderTest, FindsFilesInTheFolderAndBelow) {
    EXPECT_TRUE(folder().find_file("scene.gltf"));
    EXPECT_TRUE(folder().find_file("./deep/er/x.bin"));
    EXPECT_TRUE(folder().find_file("deep/../deep/er/x.bin"));
    EXPECT_TRUE(folder().find_file("a b.bin"));
    EXPECT_TRUE(folder().find_file("a%20b.bin"));
    EXPECT_TRUE(folder().find_file("deep\\er\\x.bin"));
    EXPECT_FALSE(folder().find_file("nothing.bin"));
    EXPECT_FALSE(folder().find_file(""));
    EXPECT_FALSE(folder().find_file("deep"));  // a folder
}

TEST_F(SceneFolderTest, RejectsFilesOutside) {
    EXPECT_FALSE(folder().find_file("/etc/passwd"));
    EXPECT_FALSE(folder().find_file("file:///etc/passwd"));
    EXPECT_FALSE(folder().find_file("../secret.bin"));
    EXPECT_FALSE(folder().find_file("..%2Fsecret.bin"));
    EXPECT_FALSE(folder().find_file("..\\secret.bin"));
    EXPECT_FALSE(folder().find_file("../../outside.bin"));
    EXPECT_FALSE(folder().find_file("../materials/textures/wood.png"));  // for images only
    EXPECT_FALSE(folder().find_image("../private/secret.png"));
    EXPECT_FALSE(folder().find_image("/etc/passwd"));
}

TEST_F(SceneFolderTest, RecordsLookups) {
    const SceneFolder original = folder();
    const SceneFolder copy = original;  // NOLINT(performance-unnecessary-copy-initialization): tests the copy
    EXPECT_TRUE(original.find_file("a%20b.bin"));
    EXPECT_FALSE(copy.find_image("nothing.png"));
    EXPECT_FALSE(copy.find_file("nothing.png"));
    EXPECT_TRUE(copy.find_file("a%20b.bin"));
    const std::vector<FileRequest> expected = {
        {"a%20b.bin", false}, {"nothing.png", true}, {"nothing.png", false}};
    EXPECT_EQ(original.requests(), expected);
    EXPECT_TRUE(original.find(expected[0]));
    EXPECT_TRUE(folder().requests().empty());
}

TEST_F(SceneFolderTest, RejectsSymbolicLinksToTheOutside) {
    fs::create_symlink(files_.path() / "outside.bin", files_.path() / "model/meshes/link.bin");
    fs::create_symlink(files_.path() / "model/meshes/deep/er/x.bin",
                       files_.path() / "model/meshes/inner.bin");
    EXPECT_FALSE(folder().find_file("link.bin"));
    EXPECT_TRUE(folder().find_file("inner.bin"));
}

TEST_F(SceneFolderTest, FindsImagesWhereExportersPutThem) {
    EXPECT_TRUE(folder().find_image("textures/own.png"));
    EXPECT_TRUE(folder().find_image("../materials/textures/wood.png"));
    EXPECT_TRUE(folder().find_image("../Textures/stone.png"));
    EXPECT_TRUE(folder().find_image("wood.png"));                 // a bare name
    EXPECT_TRUE(folder().find_image("C:\\Users\\ann\\own.png"));  // another machine's path
    EXPECT_TRUE(folder().find_image("own.png\r"));
    EXPECT_FALSE(folder().find_image("marble.png"));
}

TEST_F(SceneFolderTest, FindsNoImageBesideTheFolderIfThatIsForbidden) {
    SceneFile file = scene();
    file.images_beside = false;
    EXPECT_TRUE(SceneFolder(file).find_image("own.png"));
    EXPECT_FALSE(SceneFolder(file).find_image("../materials/textures/wood.png"));
    EXPECT_FALSE(SceneFolder(file).find_image("wood.png"));
    EXPECT_THAT(SceneFolder(file).readable_paths(),
                Not(Contains(Property(&std::filesystem::path::filename, "materials"))));
}

TEST_F(SceneFolderTest, FindsFilesBelowOtherRoots) {
    files_.write("elsewhere/x.bin", "x");
    files_.write("elsewhere/.git/config", "x");
    std::filesystem::create_symlink("../../elsewhere/x.bin", files_.path() / "model/meshes/linked.bin");
    EXPECT_FALSE(folder().find_file("linked.bin"));
    SceneFile file = scene();
    file.roots = {std::filesystem::canonical(files_.path() / "elsewhere")};
    EXPECT_TRUE(SceneFolder(file).find_file("linked.bin"));
    EXPECT_TRUE(SceneFolder(file).find_file("../../elsewhere/x.bin"));
    EXPECT_FALSE(SceneFolder(file).find_file("../../elsewhere/.git/config"));
    EXPECT_FALSE(SceneFolder(file).find_file("../../outside.bin"));
}

TEST(SceneFolder, FindsNothingBesideAMissingScene) {
    SceneFile file;
    file.path = "/no/such/folder/scene.gltf";
    EXPECT_FALSE(SceneFolder(file).find_file("scene.gltf"));
}

TEST(PercentDecoded, KeepsMalformedEscapes) {
    EXPECT_EQ(percent_decoded("a%20b%2Fc"), "a b/c");
    EXPECT_EQ(percent_decoded("100%"), "100%");
    EXPECT_EQ(percent_decoded("%zz%4"), "%zz%4");
}

}  // namespace
}  // namespace campuswalk::scene
