#include "engine/render/overlay/canvas.h"

#include <array>
#include <filesystem>
#include <memory>
#include <string>

#include <gtest/gtest.h>
#include <pango/pango.h>

#include "engine/render/gl/render_error.h"
#include "tests/engine/render/color_names.h"
#include "tests/engine/render/scratch_folder.h"

namespace campuswalk::engine::render::test {
namespace {

const std::array<std::uint8_t, 3> kGround = {40, 90, 40};

// The number of characters in `text` that no font has.
int missing_glyphs(const std::string& text) {
    const Fonts fonts;
    const std::unique_ptr<PangoLayout, void (*)(gpointer)> layout(pango_layout_new(fonts.context()),
                                                                  g_object_unref);
    pango_layout_set_text(layout.get(), text.data(), static_cast<int>(text.size()));
    return pango_layout_get_unknown_glyphs_count(layout.get());
}

struct PixelBounds {
    int left = 10000;
    int top = 10000;
    int right = -1;
    int bottom = -1;
};

PixelBounds drawn_bounds(const Image& image) {
    PixelBounds box;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (image.pixel(x, y) != kGround) {
                box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x),
                       std::max(box.bottom, y)};
            }
        }
    }
    return box;
}

TEST(Fonts, CoverTheScriptsOfCampusNames) {
    EXPECT_EQ(missing_glyphs("Éçole Zürich-Straße, naïve café: ąčęłńőřşťůž ØÆÅ “–” …"), 0);
    EXPECT_EQ(missing_glyphs("Ελληνικά Русский Обсерватория"), 0);
    EXPECT_EQ(missing_glyphs("总图书馆 鐘樓 日本語 한국어 藏书二十四万册。"), 0);
    EXPECT_EQ(missing_glyphs("عربى עברית"), 0);
    EXPECT_EQ(missing_glyphs("e\u0301 a\u0308"), 0) << "combining accents";
    EXPECT_EQ(missing_glyphs("\U000F0000"), 1) << "a private-use character is in no font";
}

TEST(Fonts, AreNotSubstitutedIfOneIsMissing) {
    const ScratchFolder scratch;
    const std::filesystem::path& folder = scratch.path();
    const std::array folders = {folder};
    for (const std::string name : {"DejaVuSans.ttf", "DejaVuSans-Bold.ttf", "wqy-microhei.ttc"}) {
        try {
            const Fonts fonts(folders);
            ADD_FAILURE() << name << " is missing";
        } catch (const RenderError& error) {
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
        }
        for (const std::filesystem::path& usual : Fonts::default_folders()) {
            if (std::filesystem::exists(usual / name)) {
                std::filesystem::create_symlink(usual / name, folder / name);
                break;
            }
        }
    }
    EXPECT_NO_THROW(const Fonts fonts(folders));
}

TEST(Canvas, ReturnsTheImageUnchanged) {
    Image image = plain_image(5, 3, {1, 128, 255});
    image.rgba[image.offset(4, 0)] = 77;
    image.rgba[image.offset(0, 2) + 2] = 3;
    const Fonts fonts;
    EXPECT_EQ(Canvas(image, fonts).image().rgba, image.rgba);
}

TEST(Canvas, TextSizeCoversTheDrawnPixels) {
    const Fonts fonts;
    const TextStyle style = {20.0, true, {1, 1, 1, 1}, 0.0, 1};
    for (const char* text : {"Library", "总图书馆", "École"}) {
        const Canvas canvas(plain_image(200, 60, kGround), fonts);
        const Eigen::Vector2d size = canvas.text_size(text, style);
        EXPECT_NEAR(canvas.text(10, 10, text, style), size.y(), 1e-9);
        const PixelBounds bounds = drawn_bounds(canvas.image());
        EXPECT_GE(bounds.left, 9) << text;
        EXPECT_GE(bounds.top, 9) << text;
        EXPECT_LE(bounds.right, 11 + size.x()) << text;
        EXPECT_LE(bounds.bottom, 11 + size.y()) << text;
        EXPECT_GT(bounds.right - bounds.left, 0.7 * size.x()) << text;
    }
}

TEST(Canvas, DifferentLettersLookDifferent) {
    const Fonts fonts;
    const auto image_of = [&](const char* text) {
        const Canvas canvas(plain_image(60, 60, kGround), fonts);
        canvas.text(5, 5, text, {30.0, false, {1, 1, 1, 1}, 0.0, 1});
        return canvas.image();
    };
    EXPECT_GT(differing_pixels(image_of("图"), image_of("书")), 50U);
    EXPECT_GT(differing_pixels(image_of("e"), image_of("é")), 5U);
}

TEST(Canvas, WrapsWithinWordsAndTruncatesAtTheLastLine) {
    const Fonts fonts;
    const Canvas canvas(plain_image(200, 400, kGround), fonts);
    TextStyle style = {16.0, false, {1, 1, 1, 1}, 120.0, 0};
    const std::string long_word(80, 'm');
    const double line = canvas.text_size("m", style).y();
    const Eigen::Vector2d all = canvas.text_size(long_word, style);
    EXPECT_LE(all.x(), 120.0);
    EXPECT_GT(all.y(), 5.0 * line);
    style.max_lines = 3;
    EXPECT_NEAR(canvas.text_size(long_word, style).y(), 3.0 * line, 1.0);
    canvas.text(10, 10, long_word, style);
    EXPECT_LE(drawn_bounds(canvas.image()).right, 131);
}

TEST(Canvas, LabelsAreCentredAndOutlined) {
    const Fonts fonts;
    const Canvas canvas(plain_image(201, 61, kGround), fonts);
    canvas.label(100.5, 30.5, "HOH", {24.0, true, {1, 1, 1, 1}, 0.0, 1});
    const Image image = canvas.image();
    const PixelBounds bounds = drawn_bounds(image);
    EXPECT_NEAR(0.5 * (bounds.left + bounds.right), 100.0, 1.5);
    int white = 0;
    int dark = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            white += brightness(image, x, y) > 230 ? 1 : 0;
            dark += brightness(image, x, y) < 35 ? 1 : 0;
        }
    }
    EXPECT_GT(white, 50);
    EXPECT_GT(dark, 50);
}

TEST(Canvas, ImagesKeepTheirOrientationWhenScaled) {
    Image small = plain_image(2, 2, {200, 0, 0});
    small.rgba[small.offset(1, 0)] = 0;
    small.rgba[small.offset(1, 0) + 1] = 200;  // upper right: green
    const Fonts fonts;
    const Canvas canvas(plain_image(40, 40, kGround), fonts);
    canvas.draw_image(small, 10.0, {10, 10});
    const Image image = canvas.image();
    EXPECT_EQ(color_name(image, 12, 12), "red");
    EXPECT_EQ(color_name(image, 27, 12), "green");
    EXPECT_EQ(color_name(image, 27, 27), "red");
    EXPECT_EQ(image.pixel(5, 5), kGround);
}

}  // namespace
}  // namespace campuswalk::engine::render::test
