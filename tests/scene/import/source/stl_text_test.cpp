#include "scene/import/source/stl_text.h"

#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/import/import_model.h"
#include "tests/scene/model_files.h"

namespace campuswalk::scene {
namespace {

std::string solid(const std::string& name, int x) {
    const std::string at = std::to_string(x);
    return "solid " + name + "\nfacet normal 0 0 1\nouter loop\nvertex " + at + " 0 0\nvertex " +
           std::to_string(x + 1) + " 0 0\nvertex " + at + " 1 0\nendloop\nendfacet\nendsolid " + name + "\n";
}

/// A triangle, and bytes behind it.
std::string binary(std::size_t behind) {
    std::string bytes(80, ' ');
    bytes.replace(0, 18, "solid of an export");
    bytes += std::string("\x01\0\0\0", 4);
    const std::vector<float> numbers = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(float));
    return bytes + std::string(2 + behind, '\0');
}

std::vector<std::string> names_in(const Model& model) {
    std::vector<std::string> names;
    for (const Node& node : model.nodes) {
        if (!node.meshes.empty()) {
            names.push_back(node.name);
        }
    }
    return names;
}

TEST(StlText, KeepsSpacesInNamesOfSolids) {
    test::TemporaryFolder folder;
    folder.write("rooms.stl", solid("Room 101", 0) + solid("Room\t102  east", 3) + solid("hall", 6));
    const ImportedModel imported = import_model(test::scene_file(folder, "rooms.stl"));
    EXPECT_EQ(names_in(imported.model), (std::vector<std::string>{"Room 101", "Room 102  east", "hall"}));
}

TEST(StlText, ReadsCapitalKeywords) {
    std::string text = solid("hall", 0);
    for (char& c : text) {
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    }
    test::TemporaryFolder folder;
    folder.write("upper.stl", "  " + text);
    EXPECT_EQ(names_in(import_model(test::scene_file(folder, "upper.stl")).model),
              std::vector<std::string>{"HALL"});
}

TEST(StlText, CutsWhatFollowsTheTriangles) {
    test::TemporaryFolder folder;
    for (const std::size_t behind : {0U, 1U, 1000U}) {
        folder.write("tail.stl", binary(behind));
        const Model model = import_model(test::scene_file(folder, "tail.stl")).model;
        ASSERT_EQ(model.meshes.size(), 1U) << behind;
        EXPECT_EQ(model.meshes[0].triangles.size(), 1U);
    }
}

TEST(StlText, LeavesOtherBytesAlone) {
    for (const std::string& text :
         {std::string(), std::string("solid"), std::string("abc"), std::string(84, '\xff')}) {
        std::vector<std::uint8_t> bytes(text.begin(), text.end());
        normalize_stl(bytes);
        EXPECT_EQ(std::string(bytes.begin(), bytes.end()), text);
    }
}

}  // namespace
}  // namespace campuswalk::scene
