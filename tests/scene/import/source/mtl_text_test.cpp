#include "scene/import/source/mtl_text.h"

#include <string>

#include <gtest/gtest.h>

#include "scene/import/import_model.h"
#include "tests/scene/model_files.h"

namespace campuswalk::scene {
namespace {

bool moves(const std::string& text) {
    return moves_images(std::vector<std::uint8_t>(text.begin(), text.end()));
}

TEST(MtlText, FindsImagesThatAreScaledOrMoved) {
    for (const char* moved :
         {"map_Kd -s 2 2 1 a.png", "newmtl x\n\tmap_Kd -o 0.5 0 0 a.png\r\n", "map_Kd -clamp on -s 1 3 a.png",
          "MAP_KS -t 0.1 0 0 a.png", "bump -bm 1 -o 0 0.25 a.png"}) {
        EXPECT_TRUE(moves(moved)) << moved;
    }
    for (const char* plain : {"", "map_Kd a.png", "map_Kd -s 1 1 1 -o 0 0 0 a.png", "map_Kd -s a.png",
                              "# map_Kd -s 2 2 2 a.png", "Ks -s 2 2 2", "map_Kd -s 1 2s.png"}) {
        EXPECT_FALSE(moves(plain)) << plain;
    }
}

TEST(MtlText, IsReportedOnce) {
    test::TemporaryFolder folder;
    folder.write("a.mtl", "newmtl wood\nmap_Kd -s 2 2 1 none.png\nnewmtl stone\nmap_Kd -o 1 0 0 none.png\n");
    folder.write("a.obj", "mtllib a.mtl\nusemtl wood\nv 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
    std::size_t reported = 0;
    for (const Diagnostic& warning : import_model(test::scene_file(folder, "a.obj")).warnings) {
        reported += warning.code == "unsupported-feature" ? 1U : 0U;
    }
    EXPECT_EQ(reported, 1U);
}

}  // namespace
}  // namespace campuswalk::scene
