#include "engine/render/overlay/info_window.h"

#include <gtest/gtest.h>

#include "tests/engine/render/color_names.h"

namespace campuswalk::engine::render::test {
namespace {

constexpr int kImageWidth = 1280;
constexpr int kImageHeight = 720;
constexpr double kShade = 7.0;  // pixels around a window that its shade may darken
const std::array<std::uint8_t, 3> kMeadow = {120, 160, 90};

InfoWindow library() {
    return {"Main Library", "library", "08-22", "Four floors of books.", 4, {}};
}

struct Drawn {
    Image image;
    std::vector<PixelRect> rects;
};

Drawn drawn(const std::vector<InfoWindow>& windows, int width = kImageWidth, int height = kImageHeight,
            std::size_t max_windows = 3) {
    const Fonts fonts;
    const Canvas canvas(plain_image(width, height, kMeadow), fonts);
    Drawn result;
    result.rects = draw_info_windows(canvas, windows, max_windows);
    result.image = canvas.image();
    return result;
}

bool within(const PixelRect& rect, double margin, int x, int y) {
    return x >= rect.x - margin && y >= rect.y - margin && x < rect.x + rect.width + margin &&
           y < rect.y + rect.height + margin;
}

std::size_t changed_outside(const Drawn& drawn) {
    std::size_t count = 0;
    for (int y = 0; y < drawn.image.height; ++y) {
        for (int x = 0; x < drawn.image.width; ++x) {
            const bool inside = std::ranges::any_of(
                drawn.rects, [&](const PixelRect& rect) { return within(rect, kShade, x, y); });
            count += !inside && drawn.image.pixel(x, y) != kMeadow ? 1U : 0U;
        }
    }
    return count;
}

// The number of pixels as bright as text between `top` and `bottom`, as shares of the window height.
int letters(const Drawn& drawn, double top, double bottom, double left = 0.02, double right = 0.85) {
    const PixelRect& rect = drawn.rects.at(0);
    int count = 0;
    for (int y = 0; y < drawn.image.height; ++y) {
        for (int x = 0; x < drawn.image.width; ++x) {
            const double u = (x - rect.x) / rect.width;
            const double v = (y - rect.y) / rect.height;
            const bool here = u > left && u < right && v > top && v < bottom;
            count += here && brightness(drawn.image, x, y) > 190 ? 1 : 0;
        }
    }
    return count;
}

TEST(ReadableHours, FormatsPlainRangesOnly) {
    EXPECT_EQ(readable_hours("08-22"), "08:00 – 22:00");
    EXPECT_EQ(readable_hours("8:30-22"), "08:30 – 22:00");
    EXPECT_EQ(readable_hours("00-24"), "00:00 – 24:00");
    for (const char* other : {"closed", "Mon-Fri", "", "08-", "-22", "08-25", "08-22 daily", "8:75-22"}) {
        EXPECT_EQ(readable_hours(other), other);
    }
}

TEST(InfoWindow, UsesTheBuildingsDataAndItsIdWithoutATitle) {
    scene::Building building;
    building.id = "clock-tower";
    building.kind = "landmark";
    building.floors = 5;
    EXPECT_EQ(info_window_of(building, {}).title, "clock-tower");
    building.title = "Clock Tower, visit {visits}";
    const InfoWindow window = info_window_of(building, {0, "Clock Tower, visit 2", "At 01:30."});
    EXPECT_EQ(window.title, "Clock Tower, visit 2");
    EXPECT_EQ(window.text, "At 01:30.");
    EXPECT_EQ(window.kind, "landmark");
    EXPECT_EQ(window.floors, 5);
    EXPECT_FALSE(window.anchor);
}

TEST(InfoWindow, DrawsTitleAndBodyWithinItsRectangle) {
    const Drawn full = drawn({library()});
    ASSERT_EQ(full.rects.size(), 1U);
    const PixelRect& rect = full.rects[0];
    EXPECT_GE(rect.x, 0.0);
    EXPECT_LE(rect.x + rect.width, kImageWidth);
    EXPECT_EQ(changed_outside(full), 0U);
    EXPECT_LT(mean_brightness(full.image, static_cast<int>(rect.x) + 4, static_cast<int>(rect.y) + 14,
                              static_cast<int>(rect.x) + 16, static_cast<int>(rect.y) + 60),
              60.0)
        << "a dark panel";
    EXPECT_GT(letters(full, 0.05, 0.30), 300) << "title";

    InfoWindow without_text = library();
    without_text.text.clear();
    EXPECT_LT(drawn({without_text}).rects[0].height, rect.height) << "empty fields take no room";
    InfoWindow without_title = library();
    without_title.title = " ";
    EXPECT_LT(letters(drawn({without_title}), 0.05, 0.22), 60);
}

TEST(InfoWindow, IsDarkWithoutText) {
    InfoWindow blank;
    blank.title = " ";
    EXPECT_EQ(letters(drawn({blank}), 0.1, 0.9), 0);
}

TEST(InfoWindow, TruncatesTextThatIsTooLongForTheImage) {
    InfoWindow window = library();
    window.title = std::string(400, 'W');
    window.text.clear();
    for (int i = 0; i < 400; ++i) {
        window.text += "Books and more books. ";
    }
    const Drawn once = drawn({window});
    EXPECT_LE(once.rects.at(0).height, 0.85 * kImageHeight);
    EXPECT_EQ(changed_outside(once), 0U);
    window.text += window.text;
    const Drawn twice = drawn({window});
    EXPECT_EQ(twice.image.rgba, once.image.rgba) << "what follows the ellipsis doesn't matter";
    EXPECT_GT(letters(once, 0.85, 0.97), 20) << "hours and floors are still there";
}

TEST(InfoWindow, BreaksWordsWiderThanTheWindow) {
    InfoWindow window = library();
    window.text = std::string(300, 'x');
    const Drawn result = drawn({window});
    EXPECT_EQ(changed_outside(result), 0U);
    EXPECT_GT(result.rects.at(0).height, drawn({library()}).rects.at(0).height + 40.0);
}

TEST(InfoWindow, DrawsChineseAndAccentedNames) {
    InfoWindow plain = library();
    InfoWindow named = library();
    named.title = "Bibliothèque · 总图书馆";
    const Drawn result = drawn({named});
    EXPECT_EQ(changed_outside(result), 0U);
    EXPECT_GT(letters(result, 0.05, 0.30), letters(drawn({plain}), 0.05, 0.30));
}

TEST(InfoWindow, StacksWindowsAndCountsTheHiddenOnes) {
    const std::vector<InfoWindow> six(6, library());
    const Drawn stacked = drawn(six);
    ASSERT_GE(stacked.rects.size(), 2U);
    ASSERT_LE(stacked.rects.size(), 3U);
    for (std::size_t i = 1; i < stacked.rects.size(); ++i) {
        EXPECT_GE(stacked.rects[i].y, stacked.rects[i - 1].y + stacked.rects[i - 1].height);
    }
    EXPECT_LE(stacked.rects.back().y + stacked.rects.back().height, kImageHeight);
    EXPECT_GT(changed_outside(stacked), 100U) << "+n more";
    EXPECT_EQ(drawn(six, kImageWidth, kImageHeight, 1).rects.size(), 1U);
    EXPECT_TRUE(drawn({}).rects.empty());
}

TEST(InfoWindow, FitsSmallAndNarrowImages) {
    InfoWindow window = library();
    window.text = std::string(2000, 'x');
    for (const auto& [width, height] : {std::pair(320, 180), std::pair(200, 600), std::pair(3840, 2160)}) {
        const PixelRect rect = drawn({window}, width, height).rects.at(0);
        EXPECT_GE(rect.x, 0.0) << width;
        EXPECT_LE(rect.x + rect.width, width) << width;
        EXPECT_LE(rect.y + rect.height, height) << width;
    }
}

TEST(InfoWindow, DrawsALineToTheBuilding) {
    InfoWindow window = library();
    window.anchor = Eigen::Vector2d(300, 400);
    const Image image = drawn({window}).image;
    EXPECT_GT(brightness(image, 300, 400), 220.0);
    window.anchor = Eigen::Vector2d(-50, 400);
    EXPECT_EQ(changed_outside(drawn({window})), 0U) << "no line to a point outside of the image";
}

}  // namespace
}  // namespace campuswalk::engine::render::test
