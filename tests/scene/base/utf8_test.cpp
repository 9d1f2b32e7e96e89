#include "scene/base/utf8.h"

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

TEST(Utf8Length, CountsTheBytesOfEveryForm) {
    EXPECT_EQ(utf8_length("a", 0), 1U);
    EXPECT_EQ(utf8_length("é", 0), 2U);
    EXPECT_EQ(utf8_length("总", 0), 3U);
    EXPECT_EQ(utf8_length("🌳", 0), 4U);
    EXPECT_EQ(utf8_length("\xF4\x8F\xBF\xBF", 0), 4U);  // the last code point
}

TEST(Utf8Length, IsZeroForInvalidSequences) {
    for (const char* bytes :
         {"\x80", "\xC3", "\xC0\x80", "\xC1\xBF", "\xE0\x80\x80", "\xE6\x80", "\xED\xA0\x80",
          "\xF0\x80\x80\x80", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF", "\xC3(", "\xE6\x80("}) {
        EXPECT_EQ(utf8_length(bytes, 0), 0U) << bytes;
    }
}

}  // namespace
}  // namespace campuswalk::scene
