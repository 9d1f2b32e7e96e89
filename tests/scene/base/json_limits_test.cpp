#include "scene/base/json_depth.h"

#include <string>

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

std::string nested(int depth) {
    const auto size = static_cast<std::size_t>(depth);
    return std::string(size, '[') + std::string(size, ']');
}

TEST(JsonDepth, IsThatOfTheDeepestPart) {
    EXPECT_FALSE(is_nested_deeply(nested(kDeepestJson)));
    EXPECT_TRUE(is_nested_deeply(nested(kDeepestJson + 1)));
    EXPECT_FALSE(is_nested_deeply("[" + nested(kDeepestJson - 1) + "," + nested(kDeepestJson - 1) + "]"));
    EXPECT_TRUE(is_nested_deeply(R"({"a":)" + nested(kDeepestJson) + "}"));
}

TEST(JsonDepth, CountsNoBracketsInStrings) {
    const std::string brackets(kDeepestJson + 1, '[');
    EXPECT_FALSE(is_nested_deeply("\"" + brackets + "\""));
    EXPECT_FALSE(is_nested_deeply(R"("\")" + brackets + "\""));
    EXPECT_TRUE(is_nested_deeply(R"("\\")" + brackets));
}

}  // namespace
}  // namespace campuswalk::scene
