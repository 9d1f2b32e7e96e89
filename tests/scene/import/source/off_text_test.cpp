#include "scene/import/source/off_text.h"

#include <string>

#include <gtest/gtest.h>

#include "scene/import/import_model.h"
#include "tests/scene/model_files.h"

namespace campuswalk::scene {
namespace {

/// A convex face of so many vertices.
std::string polygon(int vertices, const std::string& header) {
    std::string text = header + "\n# a floor\n" + std::to_string(vertices) + " 1 0\n\n";
    std::string face = std::to_string(vertices);
    for (int i = 0; i < vertices; ++i) {
        text += std::to_string(i) + " 0 " + std::to_string(i * i) + "  # a vertex\n";
        face += " " + std::to_string(i);
    }
    return text + face + "\n";
}

std::string fault(const std::string& text) {
    return fault_of_off(std::vector<std::uint8_t>(text.begin(), text.end()));
}

TEST(OffText, NamesTheFirstFaceThatHasTooManyVertices) {
    EXPECT_EQ(fault(polygon(9, "OFF")), "");
    for (const char* header : {"OFF", "COFF", "OFF # of a scan"}) {
        EXPECT_TRUE(fault(polygon(10, header)).starts_with("its face 1 has 10 vertices")) << header;
    }
    EXPECT_TRUE(fault("OFF 4 2 0\n0 0 0\n1 0 0\n1 0 1\n0 0 1\n3 0 1 2\n12 0 1 2 3 0 1 2 3 0 1 2 3\n")
                    .starts_with("its face 2 has 12 vertices"));
    for (const char* odd : {"", "OFF", "OFF\n", "OFF\n4 999999 0\n", "OFF\nx y z\n",
                            "18446744073709551615 1 1", "OFF\n1 18446744073709551615 0\n0 0 0\n"}) {
        EXPECT_EQ(fault(odd), "") << odd;
    }
}

TEST(OffText, IsReadOrRefused) {
    test::TemporaryFolder folder;
    folder.write("nine.off", polygon(9, "OFF"));
    EXPECT_EQ(count_triangles(import_model(test::scene_file(folder, "nine.off")).model), 7U);
    folder.write("ten.off", polygon(10, "OFF"));
    const auto errors = test::errors_of([&] { import_model(test::scene_file(folder, "ten.off")); });
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_NE(errors[0].message.find("its face 1 has 10 vertices"), std::string::npos) << errors[0].message;
}

}  // namespace
}  // namespace campuswalk::scene
