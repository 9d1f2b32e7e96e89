#include "engine/render/passes/shader_constants.h"

#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace campuswalk::engine::render {
namespace {

// Parses the numbers in the last parentheses.
std::vector<float> read_back(const ShaderConstants& constants) {
    std::string text(constants.text());
    text = text.substr(text.rfind('(') + 1);
    text = text.substr(0, text.find(')'));
    for (char& c : text) {
        c = c == ',' ? ' ' : c;
    }
    std::istringstream numbers(text);
    std::vector<float> values;
    for (float value = 0.0F; numbers >> value;) {
        values.push_back(value);
    }
    return values;
}

TEST(ShaderConstants, RoundTripAsFloats) {
    for (const double value : {0.0, 1.0, -3.0, 0.1, 1e-7, 3.4e38, 16777216.0, 1.0 / 3.0, -1e-30}) {
        EXPECT_EQ(read_back(ShaderConstants().add("x", value)), std::vector{static_cast<float>(value)});
    }
}

TEST(ShaderConstants, AreNeverInts) {
    EXPECT_EQ(ShaderConstants().add("x", 2.0).text(), "const float x = float(2.0);\n");
    EXPECT_EQ(ShaderConstants().add("v", Eigen::Vector2d(1, -4)).text(), "const vec2 v = vec2(1.0, -4.0);\n");
}

TEST(ShaderConstants, MatricesAreColumnMajor) {
    Eigen::Matrix3d m;
    m << 1, 2, 3, 4, 5, 6, 7, 8, 9;
    EXPECT_EQ(read_back(ShaderConstants().add("m", m)), (std::vector<float>{1, 4, 7, 2, 5, 8, 3, 6, 9}));
}

}  // namespace
}  // namespace campuswalk::engine::render
