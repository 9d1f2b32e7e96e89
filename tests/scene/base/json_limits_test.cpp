#include "scene/base/json_limits.h"

#include <string>

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

std::string nested(int depth) {
    const auto size = static_cast<std::size_t>(depth);
    return std::string(size, '[') + std::string(size, ']');
}

/// `{"0":VALUE,"1":VALUE,…}`
std::string object(int members, const std::string& value) {
    std::string text = "{";
    for (int i = 0; i < members; ++i) {
        text += (i == 0 ? "\"" : ",\"") + std::to_string(i) + "\":" + value;
    }
    return text + "}";
}

TEST(JsonLimits, DepthIsThatOfTheDeepestPart) {
    EXPECT_EQ(why_too_complex(nested(kDeepestJson)), "");
    EXPECT_EQ(why_too_complex(nested(kDeepestJson + 1)), "it is nested deeply");
    EXPECT_EQ(why_too_complex("[" + nested(kDeepestJson - 1) + "," + nested(kDeepestJson - 1) + "]"), "");
    EXPECT_NE(why_too_complex(R"({"a":)" + nested(kDeepestJson) + "}"), "");
    EXPECT_NE(why_too_complex("]]]" + nested(kDeepestJson + 1)), "");
}

TEST(JsonLimits, StringsHaveNoBracketsAndNoMembers) {
    const std::string brackets(kDeepestJson + 1, '[');
    EXPECT_EQ(why_too_complex("\"" + brackets + "\""), "");
    EXPECT_EQ(why_too_complex(R"("\")" + brackets + "\""), "");
    EXPECT_NE(why_too_complex(R"("\\")" + brackets), "");
    EXPECT_EQ(why_too_complex("\"" + std::string(5000, ':') + "\""), "");
}

TEST(JsonLimits, MembersCountByObject) {
    const std::string most = object(kMostJsonMembers, "1");
    EXPECT_EQ(why_too_complex(most), "");
    EXPECT_EQ(why_too_complex(object(kMostJsonMembers, R"({"a":1})")), "");
    EXPECT_EQ(why_too_complex("[" + most + "," + most + "]"), "");
    EXPECT_EQ(why_too_complex("[" + std::string(9000, '1') + nested(3) + "]"), "");
    EXPECT_EQ(why_too_complex(object(kMostJsonMembers + 1, "1")),
              "an object in it has more than 1000 members");
    EXPECT_NE(why_too_complex("[{\"a\":" + object(kMostJsonMembers + 1, most) + "}]"), "");
}

}  // namespace
}  // namespace campuswalk::scene
