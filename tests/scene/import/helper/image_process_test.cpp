#include "scene/import/helper/image_process.h"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

/// 2 x 1 pixels: red, and green at half opacity. Made by Python's zlib.
constexpr std::string_view kPng(
    "\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122\000\000\000\002"
    "\000\000\000\001\010\006\000\000\000\364\042\177\212\000\000\000\017\111\104\101"
    "\124\170\332\143\370\317\300\360\037\010\033\000\020\171\003\176\304\030\162\220"
    "\000\000\000\000\111\105\116\104\256\102\140\202",
    72);

std::vector<ForeignImage> decoded(const char* behaviour, const std::vector<std::string_view>& files) {
    return decode_in_process({ODD_IMPORT_HELPER, {behaviour}}, files, SandboxMode::automatic);
}

TEST(ImageProcess, DecodesManyAtOnce) {
    const auto images = decoded("images", {kPng, kPng, kPng});
    ASSERT_EQ(images.size(), 3U);
    for (const ForeignImage& image : images) {
        EXPECT_EQ(image.fault, "");
        EXPECT_EQ(image.size.width, 2U);
        EXPECT_EQ(image.size.height, 1U);
        EXPECT_EQ(std::vector<int>(image.rgba.begin(), image.rgba.end()),
                  (std::vector<int>{255, 0, 0, 255, 0, 255, 0, 128}));
    }
}

TEST(ImageProcess, DecodesNothingButPng) {
    std::string tga("\0\0\x02\0\0\0\0\0\0\0\0\0\x01\0\x01\0\x18\0", 18);
    tga += "abc";
    const std::string gif = "GIF89a\x01\0\x01";
    const std::string cut(kPng.substr(0, 50));
    const auto images = decoded("images", {tga, kPng, gif, "", cut});
    for (const std::size_t other : {0U, 2U, 3U, 4U}) {
        EXPECT_NE(images[other].fault, "") << other;
        EXPECT_TRUE(images[other].rgba.empty()) << other;
    }
    EXPECT_EQ(images[1].fault, "");
}

TEST(ImageProcess, FailsForAllIfItCrashesOrLies) {
    for (const char* behaviour : {"crash", "abort", "serve", "nothing"}) {
        const auto images = decoded(behaviour, {kPng, kPng});
        ASSERT_EQ(images.size(), 2U) << behaviour;
        EXPECT_NE(images[0].fault, "") << behaviour;
        EXPECT_NE(images[1].fault, "") << behaviour;
    }
}

TEST(ImageProcess, ReadsASizeWithoutDecoding) {
    EXPECT_EQ(png_size(kPng)->pixels(), 2U);
    EXPECT_EQ(png_size(kPng.substr(0, 24))->width, 2U);
    std::string large(kPng);
    large.replace(16, 8, 8, '\xff');
    EXPECT_EQ(png_size(large)->pixels(), 0xFFFFFFFEULL * 0x100000000ULL + 1U);
    EXPECT_FALSE(png_size(kPng.substr(0, 23)));
    EXPECT_FALSE(png_size("GIF89a" + std::string(100, 'x')));
    EXPECT_FALSE(png_size(""));
}

}  // namespace
}  // namespace campuswalk::scene
