#include "engine/render/overlay/map_marks.h"

#include <gtest/gtest.h>

#include "tests/engine/render/color_names.h"

namespace campuswalk::engine::render::test {
namespace {

const std::array<std::uint8_t, 3> kLawn = {60, 110, 60};
constexpr int kSide = 400;

Viewpoint map_view() {
    scene::Bounds bounds;
    bounds.extend({-100, 0, -100});
    bounds.extend({100, 10, 100});
    Viewpoint view = plan(bounds, 1.0);
    view.height = 200.0;  // two pixels per metre
    return view;
}

class MapMarks : public testing::Test {
protected:
    Fonts fonts_;
    Canvas canvas_{plain_image(kSide, kSide, kLawn), fonts_};

    int marked(int left, int top, int right, int bottom) const {
        const Image image = canvas_.image();
        int count = 0;
        for (int y = top; y < bottom; ++y) {
            for (int x = left; x < right; ++x) {
                count += image.pixel(x, y) != kLawn ? 1 : 0;
            }
        }
        return count;
    }
};

TEST(RoundLength, IsOneTwoOrFiveTimesAPowerOfTen) {
    for (const auto& [metres, expected] :
         {std::pair(1.0, 1.0), std::pair(1.9, 1.0), std::pair(2.0, 2.0), std::pair(49.0, 20.0),
          std::pair(50.0, 50.0), std::pair(999.0, 500.0), std::pair(0.03, 0.02)}) {
        EXPECT_NEAR(round_length(metres), expected, 1e-9) << metres;
    }
}

TEST_F(MapMarks, ScaleBarHasTheLengthOfItsLabel) {
    // 960 x 720 pixels at 3.6 per metre: 18 % of the width are 48 m, so the bar is labelled 20 m.
    const Canvas canvas(plain_image(960, 720, kLawn), fonts_);
    draw_scale_bar(canvas, map_view());
    const Image image = canvas.image();
    int longest = 0;
    for (int y = image.height / 2; y < image.height; ++y) {
        int run = 0;
        for (int x = 0; x < image.width; ++x) {
            run = brightness(image, x, y) > 180 ? run + 1 : 0;
            longest = std::max(longest, run);
        }
    }
    EXPECT_NEAR(longest, 20.0 * 3.6, 3.0);
}

TEST_F(MapMarks, HeadingArrowPointsAlongTheYaw) {
    // The tip is farther from the middle than the barbs.
    draw_heading_arrow(canvas_, {100, 100}, 0.0, 20.0);
    EXPECT_GT(marked(98, 78, 103, 84), 0) << "north is up";
    EXPECT_EQ(marked(98, 118, 103, 124), 0);
    draw_heading_arrow(canvas_, {300, 300}, 1.5707963267948966, 20.0);
    EXPECT_GT(marked(278, 298, 284, 303), 0) << "a left turn from north is west, left on the map";
    EXPECT_EQ(marked(318, 298, 324, 303), 0);
}

TEST_F(MapMarks, PathConnectsItsPoints) {
    const std::vector<Eigen::Vector3d> path = {{-50, 0, 0}, {50, 0, 0}, {50, 3, -50}};
    draw_path(canvas_, map_view(), path);
    const Image image = canvas_.image();
    EXPECT_EQ(color_name(image, 200, 200), "yellow");
    EXPECT_EQ(color_name(image, 300, 150), "yellow");
    EXPECT_EQ(image.pixel(200, 150), kLawn);
}

TEST_F(MapMarks, LabelsAreDrawnAtTheirBuildings) {
    const std::vector<MapLabel> labels = {{"Library", {0, 0, 0}}};
    draw_map_labels(canvas_, map_view(), labels);
    EXPECT_GT(marked(160, 185, 240, 215), 200);
    EXPECT_EQ(marked(0, 0, kSide, 150) + marked(0, 250, kSide, kSide), 0);
}

TEST_F(MapMarks, OverlappingLabelsMoveAside) {
    const std::vector<MapLabel> labels = {{"Library", {0, 0, 0}}, {"Tower", {2, 0, 1}}};
    draw_map_labels(canvas_, map_view(), std::span(labels).first(1));
    const int alone = marked(0, 0, kSide, kSide);
    const int middle = marked(180, 192, 220, 208);
    Canvas both(plain_image(kSide, kSide, kLawn), fonts_);
    draw_map_labels(both, map_view(), labels);
    const Image image = both.image();
    int all = 0;
    int covered = 0;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const bool mark = image.pixel(x, y) != kLawn;
            all += mark ? 1 : 0;
            covered += mark && x >= 180 && x < 220 && y >= 192 && y < 208 ? 1 : 0;
        }
    }
    EXPECT_GT(all, alone + 100) << "both names are drawn";
    EXPECT_EQ(covered, middle) << "the first one is untouched";
}

TEST_F(MapMarks, LabelsAndCompassAvoidWindows) {
    const PixelRect window = {250, 20, 140, 120};
    const std::vector<PixelRect> windows = {window};
    const std::vector<PixelLabel> labels = {{"Hall", {320, 80}}, {"Gate", {248, 80}}, {"Pond", {100, 80}}};
    draw_labels(canvas_, labels, windows);
    draw_compass(canvas_, 0.3, windows);
    EXPECT_EQ(marked(250, 20, 390, 140), 0);
    EXPECT_GT(marked(200, 60, 250, 100), 20) << "moved to its left";
    EXPECT_GT(marked(80, 60, 120, 100), 20);
    EXPECT_GT(marked(180, 0, 250, 60), 50) << "the compass";
    const Canvas free(plain_image(kSide, kSide, kLawn), fonts_);
    draw_compass(free, 0.3);
    EXPECT_NE(free.image().pixel(370, 31), kLawn) << "in the corner if that is free";
}

TEST_F(MapMarks, LabelsOutsideOfTheImageAreOmitted) {
    const std::vector<MapLabel> labels = {{"Far away", {900, 0, 0}}};
    draw_map_labels(canvas_, map_view(), labels);
    EXPECT_EQ(marked(0, 0, kSide, kSide), 0);
}

}  // namespace
}  // namespace campuswalk::engine::render::test
