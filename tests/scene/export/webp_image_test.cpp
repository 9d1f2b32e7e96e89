#include "scene/export/webp_image.h"

#include <webp/decode.h>

#include <cstddef>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/dice.h"

namespace campuswalk::scene {
namespace {

Pixels noise(int width, int height) {
    support::Dice dice(5);
    Pixels pixels{width, height, {}};
    for (int i = 0; i < 4 * width * height; ++i) {
        pixels.rgba.push_back(static_cast<std::uint8_t>(i % 4 == 3 ? 255 : dice.below(256)));
    }
    return pixels;
}

Pixels decoded(const std::string& file) {
    Pixels pixels;
    std::uint8_t* rgba = WebPDecodeRGBA(reinterpret_cast<const std::uint8_t*>(file.data()), file.size(),
                                        &pixels.width, &pixels.height);
    if (rgba != nullptr) {
        pixels.rgba.assign(rgba, rgba + std::ptrdiff_t{4} * pixels.width * pixels.height);
        WebPFree(rgba);
    }
    return pixels;
}

TEST(WebPImage, LosslessKeepsEveryPixel) {
    const Pixels image = noise(37, 21);
    const Pixels back = decoded(encode_webp_lossless(image.view()));
    EXPECT_EQ(back.width, 37);
    EXPECT_EQ(back.height, 21);
    EXPECT_EQ(back.rgba, image.rgba);
}

TEST(WebPImage, LossyIsSmallerAndNearlyTheSame) {
    Pixels image{64, 64, {}};
    for (int i = 0; i < 64 * 64; ++i) {
        for (const int value : {i % 64 * 4, i / 64 * 4, 128, 255}) {
            image.rgba.push_back(static_cast<std::uint8_t>(value));
        }
    }
    const std::string file = encode_webp(image.view(), 80.0F);
    EXPECT_LT(file.size(), 2000U);
    const Pixels back = decoded(file);
    ASSERT_EQ(back.rgba.size(), image.rgba.size());
    int difference = 0;
    for (std::size_t i = 0; i < back.rgba.size(); ++i) {
        difference += std::abs(back.rgba[i] - image.rgba[i]);
    }
    EXPECT_LT(difference / static_cast<int>(back.rgba.size()), 4);
}

TEST(WebPImage, ShrinksToTheMeanOfWhatAPixelCovers) {
    const Pixels image{4, 2, {0,   0, 0, 255, 100, 0, 0, 255, 10, 0, 0, 255, 10, 0, 0, 255,
                              100, 0, 0, 255, 200, 0, 0, 255, 10, 0, 0, 255, 10, 0, 0, 255}};
    const Pixels small = shrunk_to_fit(image.view(), 2, 2);
    EXPECT_EQ(small.width, 2);
    EXPECT_EQ(small.height, 1);
    EXPECT_EQ(small.rgba, (std::vector<std::uint8_t>{100, 0, 0, 255, 10, 0, 0, 255}));
}

TEST(WebPImage, KeepsProportionsAndNeverGrows) {
    const Pixels image = noise(1000, 300);
    EXPECT_EQ(shrunk_to_fit(image.view(), 2000, 2000).rgba, image.rgba);
    const Pixels small = shrunk_to_fit(image.view(), 512, 512);
    EXPECT_EQ(small.width, 512);
    EXPECT_EQ(small.height, 154);
    EXPECT_EQ(small.rgba.size(), 4U * 512U * 154U);
}

}  // namespace
}  // namespace campuswalk::scene
