#include "engine/render/sequence/scaled_image.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/engine/render/color_names.h"
#include "tests/engine/render/compare/synthetic_images.h"

namespace campuswalk::engine::render::test {
namespace {

double linear(double value) {
    const double s = value / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

double encoded(double value) {
    return 255.0 * (value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055);
}

TEST(ScaledImage, IsTheMeanInLinearLight) {
    std::mt19937 random(1);
    const Image image = noise(60, 40, random);
    const Image small = scaled_down(image, 20);
    ASSERT_EQ(small.width, 20);
    ASSERT_EQ(small.height, 13);
    // A third of the width; the 40 rows become 13: rows 0 to 2, 3 to 5, …
    double sum = 0.0;
    for (int y = 3; y < 6; ++y) {
        for (int x = 21; x < 24; ++x) {
            sum += linear(image.pixel(x, y)[1]);
        }
    }
    EXPECT_NEAR(small.pixel(7, 1)[1], encoded(sum / 9.0), 0.75);
}

TEST(ScaledImage, UniformColoursAreUnchanged) {
    for (const int value : {0, 1, 60, 128, 254, 255}) {
        const auto byte = static_cast<std::uint8_t>(value);
        const Image small = scaled_down(plain_image(1280, 720, {byte, byte, 7}), 640);
        ASSERT_EQ(small.height, 360);
        EXPECT_EQ(small.pixel(300, 200), (std::array<std::uint8_t, 3>{byte, byte, 7}));
    }
}

TEST(ScaledImage, IsNeverEnlarged) {
    EXPECT_EQ(scaled_down(plain_image(10, 10, {1, 2, 3}), 20).width, 10);
    EXPECT_EQ(scaled_down(plain_image(3000, 1, {1, 2, 3}), 20).height, 1);
}

}  // namespace
}  // namespace campuswalk::engine::render::test
