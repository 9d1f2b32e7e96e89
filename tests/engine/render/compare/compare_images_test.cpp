#include "engine/render/compare/compare_images.h"

#include <random>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/render/color_names.h"
#include "tests/engine/render/compare/synthetic_images.h"
#include "tests/support/says.h"

namespace campuswalk::engine::render::test {
namespace {

using support::mentions;
using testing::ElementsAre;
using testing::IsEmpty;

/// Each violated limit, in words.
std::vector<std::string> violations(const Image& a, const Image& b, const ImageTolerance& tolerance = {}) {
    std::istringstream description(describe_violations(compare_images(a, b, tolerance), tolerance));
    std::vector<std::string> limits;
    for (std::string limit; std::getline(description, limit, ';');) {
        limits.push_back(limit);
    }
    return limits;
}

/// Makes the first `count` pixels white.
Image with_white(Image image, int count) {
    for (int i = 0; i < count; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            image.rgba[4 * static_cast<std::size_t>(i) + c] = 255;
        }
    }
    return image;
}

const Image kBlack = plain_image(100, 100, {0, 0, 0});
constexpr double kAny = -1.0;  // similarity

TEST(CompareImages, EqualImagesAreEqual) {
    std::mt19937 random(1);
    const Image image = noise(70, 70, random);
    ImageTolerance strict;
    strict.threshold = 0.0;
    strict.min_tile_ssim = 1.0;
    EXPECT_THAT(violations(image, image, strict), IsEmpty());
    strict.masks = {{0, 0, 3, 3}};
    EXPECT_THAT(violations(image, image, strict), IsEmpty());
    EXPECT_EQ(compare_images(image, image, {}).worst.ssim, 1.0);
}

TEST(CompareImages, WithoutLimitsNoPixelMayDiffer) {
    ImageTolerance tolerance;
    tolerance.min_tile_ssim = kAny;
    EXPECT_THAT(violations(kBlack, with_white(kBlack, 1), tolerance),
                ElementsAre(mentions({"1 pixel ", "0.010 %", " 0"})));
    EXPECT_THAT(violations(kBlack, with_white(kBlack, 30), tolerance),
                ElementsAre(mentions({"30 pixels ", "0.300 %", " 0"})));
}

TEST(CompareImages, AllLimitsApply) {
    ImageTolerance tolerance;
    tolerance.min_tile_ssim = kAny;
    tolerance.max_diff_pixels = 30;
    EXPECT_THAT(violations(kBlack, with_white(kBlack, 30), tolerance), IsEmpty());
    EXPECT_THAT(violations(kBlack, with_white(kBlack, 31), tolerance),
                ElementsAre(mentions({"31 pixels ", "0.310 %", " 30"})));
    tolerance.max_diff_pixel_ratio = 0.002;
    EXPECT_THAT(violations(kBlack, with_white(kBlack, 30), tolerance),
                ElementsAre(mentions({"0.300 %", "0.200 %"})));
    tolerance.max_diff_pixels.reset();
    EXPECT_THAT(violations(kBlack, with_white(kBlack, 20), tolerance), IsEmpty());
}

TEST(CompareImages, StructureIsComparedBelowTheThreshold) {
    // Stripes of 20 levels are within the pixel threshold, but change the structure of a uniform wall.
    const Image even = plain_image(64, 64, {100, 100, 100});
    Image striped = even;
    for (int y = 0; y < 64; y += 2) {
        for (int x = 0; x < 64; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                striped.rgba[striped.offset(x, y) + c] = 120;
            }
        }
    }
    const ImageComparison comparison = compare_images(even, striped, {});
    EXPECT_EQ(comparison.pixels.different, 0U);
    // Every window is half 120 and half 100: variances 100 and 0, means 110 and 100.
    const double expected =
        (2 * 100 * 110 + 6.5025) * 58.5225 / ((100 * 100 + 110 * 110 + 6.5025) * (100 + 58.5225));
    EXPECT_NEAR(comparison.worst.ssim, expected, 1e-9);
    EXPECT_THAT(violations(even, striped), ElementsAre(mentions({"64x64", "0,0", "0.367", "0.970"})));
}

TEST(CompareImages, DescribesAllViolations) {
    const std::vector<std::string> both = violations(kBlack, plain_image(100, 100, {255, 255, 255}));
    EXPECT_THAT(both, ElementsAre(mentions({"10000 pixels ", "100.000 %"}),
                                  mentions({"64x64", "0,0", "0.000", "0.970", "4 of 4"})));
}

TEST(CompareImages, DefaultsAllowForAnotherProcessorsRounding) {
    // As measured: up to 0.24 % of the pixels differ by up to 15 levels. A uniform image is the worst case.
    std::mt19937 random(9);
    for (int draw = 0; draw < 20; ++draw) {
        const Image even = plain_image(1280, 720, {90, 120, 150});
        const Image other = disturbed(even, 0.0024, 15, random);
        EXPECT_THAT(violations(even, other), IsEmpty());
        const Image rough = noise(320, 180, random);
        EXPECT_THAT(violations(rough, disturbed(rough, 0.0024, 15, random)), IsEmpty());
    }
}

TEST(DrawDifference, ColorsEveryVerdict) {
    const Image a = plain_image(200, 100, {100, 100, 100});
    Image b = a;
    for (int x = 0; x < 40; ++x) {
        b.rgba[b.offset(x, 10)] = 255;  // red: beyond the threshold
        b.rgba[b.offset(x, 50)] = 130;  // within
    }
    ImageTolerance tolerance;
    tolerance.masks = {{150, 50, 20, 20}};
    const Image drawn = draw_difference(a, b, compare_images(a, b, tolerance), tolerance);
    EXPECT_EQ(drawn.width, 200);
    EXPECT_EQ(drawn.pixel(20, 10), (std::array<std::uint8_t, 3>{220, 0, 0}));
    const auto [red, green, blue] = drawn.pixel(20, 50);
    EXPECT_EQ(red, 255) << "orange";
    EXPECT_LT(blue, 200);
    EXPECT_GT(green, blue);
    EXPECT_EQ(drawn.pixel(0, 30), (std::array<std::uint8_t, 3>{200, 0, 200})) << "the tile's border";
    const auto same = drawn.pixel(110, 80);
    EXPECT_EQ(same[0], same[2]) << "grey";
    EXPECT_GT(same[0], 200) << "pale";
    EXPECT_NE(drawn.pixel(160, 60)[2], drawn.pixel(160, 60)[0]) << "a mask's tint";
    EXPECT_NE(draw_difference(a, b, compare_images(a, b, {}), {}).rgba, drawn.rgba);
}

}  // namespace
}  // namespace campuswalk::engine::render::test
