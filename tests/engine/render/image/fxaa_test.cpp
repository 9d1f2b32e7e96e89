#include "engine/render/image/fxaa.h"

#include <cmath>
#include <span>

#include <gtest/gtest.h>

#include "engine/render/renderer.h"
#include "tests/engine/render/color_names.h"
#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

constexpr int kSide = 64;

// The share of the pixel that is below the line y = offset + slope * x, by sampling.
double covered(int x, int y, double offset, double slope) {
    constexpr int kPoints = 16;
    int below = 0;
    for (int i = 0; i < kPoints; ++i) {
        for (int j = 0; j < kPoints; ++j) {
            below += y + (j + 0.5) / kPoints > offset + slope * (x + (i + 0.5) / kPoints) ? 1 : 0;
        }
    }
    return static_cast<double>(below) / (kPoints * kPoints);
}

// White below the line, black above, sampled at pixel centres; with `turned`, x and y are swapped.
Image stairs(double offset, double slope, bool turned) {
    Image image = plain_image(kSide, kSide, {0, 0, 0});
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            if (y + 0.5 > offset + slope * (x + 0.5)) {
                std::uint8_t* rgb = &image.rgba[turned ? image.offset(y, x) : image.offset(x, y)];
                rgb[0] = rgb[1] = rgb[2] = 255;
            }
        }
    }
    return image;
}

// The linear light of a byte, by the definition of sRGB.
double light(std::uint8_t byte) {
    const double s = byte / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

// The error against the ideal line, in linear light.
double error(const Image& image, double offset, double slope, bool turned) {
    double sum = 0.0;
    for (int y = 8; y < kSide - 8; ++y) {
        for (int x = 8; x < kSide - 8; ++x) {
            const double drawn = light((turned ? image.pixel(y, x) : image.pixel(x, y))[0]);
            sum += std::pow(drawn - covered(x, y, offset, slope), 2);
        }
    }
    return std::sqrt(sum);
}

TEST(Fxaa, AliasedEdgesComeCloserToTheIdealLine) {
    for (const bool turned : {false, true}) {
        for (const double slope : {0.09, -0.17, 0.3, -0.45, 0.8}) {
            const double offset = slope > 0 ? 10.3 : 50.4;
            const Image before = stairs(offset, slope, turned);
            const double rough = error(before, offset, slope, turned);
            const double smooth = error(apply_fxaa(before), offset, slope, turned);
            EXPECT_LT(smooth, 0.66 * rough) << "slope " << slope;
        }
    }
}

// An image's error in brightness against one drawn with 16 samples per pixel, at its edges.
double error_at_edges(const Image& image, const Image& plain, const Image& many) {
    double sum = 0.0;
    for (int y = 0; y < many.height; ++y) {
        for (int x = 0; x < many.width; ++x) {
            if (std::abs(brightness(plain, x, y) - brightness(many, x, y)) > 8.0) {
                sum += std::pow(brightness(image, x, y) - brightness(many, x, y), 2);
            }
        }
    }
    return std::sqrt(sum);
}

TEST(Fxaa, RenderedImagesComeCloserToSupersampledOnes) {
    constexpr int kDrawnWidth = 320;
    constexpr int kDrawnHeight = 180;
    const scene::Model model = tower_scene();
    RenderSettings settings = quick_settings();
    settings.samples = 1;
    settings.ambient_occlusion_radius = 0.0;
    Renderer renderer(std::span(&model, 1), settings);
    const Image many = downsampled_by_two(
        downsampled_by_two(renderer.draw(tower_view(), 4 * kDrawnWidth, 4 * kDrawnHeight)));
    const Image plain = renderer.draw(tower_view(), kDrawnWidth, kDrawnHeight);
    const double rough = error_at_edges(plain, plain, many);
    ASSERT_GT(rough, 100.0) << "there is aliasing";
    EXPECT_LT(error_at_edges(apply_fxaa(plain), plain, many), 0.75 * rough) << rough;
}

TEST(Fxaa, FlatAreasAndStraightEdgesAreUnchanged) {
    const Image flat = plain_image(40, 30, {90, 120, 30});
    EXPECT_EQ(apply_fxaa(flat).rgba, flat.rgba);
    const Image straight = stairs(20.0, 0.0, false);
    EXPECT_EQ(differing_pixels(apply_fxaa(straight), straight), 0U);
}

TEST(Fxaa, AcceptsImagesOfOnePixel) {
    EXPECT_EQ(apply_fxaa(plain_image(1, 1, {9, 9, 9})).rgba, plain_image(1, 1, {9, 9, 9}).rgba);
    EXPECT_EQ(apply_fxaa(plain_image(3, 1, {9, 9, 9})).width, 3);
}

TEST(DownsampledByTwo, IsTheMeanInLinearLight) {
    Image image = plain_image(2, 2, {0, 0, 0});
    image.rgba[image.offset(0, 0)] = image.rgba[image.offset(1, 1)] = 255;  // red
    image.rgba[image.offset(1, 0) + 1] = 255;                               // green
    const Image half = downsampled_by_two(image);
    ASSERT_EQ(half.rgba.size(), 4U);
    // 1.055 x^(1 / 2.4) - 0.055 of a half and of a quarter.
    EXPECT_EQ(half.pixel(0, 0), (std::array<std::uint8_t, 3>{188, 137, 0}));
    for (const int grey : {0, 1, 77, 254, 255}) {
        const auto v = static_cast<std::uint8_t>(grey);
        EXPECT_EQ(downsampled_by_two(plain_image(4, 2, {v, v, v})).rgba, plain_image(2, 1, {v, v, v}).rgba);
    }
}

}  // namespace
}  // namespace campuswalk::engine::render::test
