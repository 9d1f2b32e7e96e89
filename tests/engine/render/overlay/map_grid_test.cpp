#include "engine/render/overlay/map_grid.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/render/color_names.h"

namespace campuswalk::engine::render::test {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

std::vector<std::string> labels_of(const std::vector<MapGrid::Line>& lines) {
    std::vector<std::string> labels;
    labels.reserve(lines.size());
    for (const MapGrid::Line& line : lines) {
        labels.push_back(line.label);
    }
    return labels;
}

MapGrid grid_of(const PlanFrame& frame, double width, double height) {
    return grid_across(frame, AlignedBox2d(Vector2d::Zero(), Vector2d(width, height)), 100.0);
}

TEST(PlanFrame, MapsAsTheViewDoes) {
    scene::Bounds bounds;
    bounds.extend({-30, 0, 10});
    bounds.extend({50, 10, 60});
    const Viewpoint view = plan(bounds, 16.0 / 9.0);
    const PlanFrame frame = frame_of(view, 640, 360);
    for (const Eigen::Vector3d& point : {Eigen::Vector3d(-30, 2, 10), Eigen::Vector3d(50, 0, 17)}) {
        const auto expected = pixel_of(view, 640, 360, point);
        ASSERT_TRUE(expected);
        EXPECT_LT((frame.pixel_of({point.x(), point.z()}) - *expected).norm(), 1e-9);
    }
}

TEST(MapGrid, LinesAreAtRoundCoordinates) {
    const MapGrid grid = grid_of({{-47.0, 12.0}, 5.0}, 400.0, 300.0);
    EXPECT_EQ(grid.spacing, 20.0);
    EXPECT_THAT(labels_of(grid.x), testing::ElementsAre("x = -40", "-20", "0", "20"));
    EXPECT_THAT(labels_of(grid.z), testing::ElementsAre("z = 20", "40", "60"));
    EXPECT_NEAR(grid.x[0].pixel, 35.0, 1e-9);
    EXPECT_NEAR(grid.z[2].pixel, 240.0, 1e-9);
}

TEST(MapGrid, HasFewLinesHoweverFarAway) {
    for (const double far : {1e16, 1e20, 1e30, 1e300}) {
        EXPECT_LE(grid_of({{far, -far}, 5.0}, 400.0, 300.0).x.size(), 5U) << far;
        EXPECT_LE(grid_of({{far, -far}, 5.0}, 400.0, 300.0).z.size(), 4U) << far;
    }
}

TEST(MapGrid, SpacingFollowsTheScale) {
    for (int i = 0; i < 205; ++i) {
        const double pixels_per_metre = 0.003 * std::pow(1.07, i);
        const double pixels = grid_of({{0, 0}, pixels_per_metre}, 500, 500).spacing * pixels_per_metre;
        EXPECT_GE(pixels, 63.9) << pixels_per_metre;
        EXPECT_LE(pixels, 160.1) << pixels_per_metre;
    }
}

TEST(MapGrid, ShortSpacingsHaveDecimalsAndFarCoordinatesNoExponent) {
    EXPECT_THAT(labels_of(grid_of({{-0.3, 0.0}, 500.0}, 250.0, 100.0).x),
                testing::ElementsAre("x = -0.2", "0.0", "0.2"));
    EXPECT_THAT(labels_of(grid_of({{84100.0, 4471003.0}, 10.0}, 150.0, 150.0).z),
                testing::ElementsAre("z = 4471010"));
}

TEST(MapGrid, IsDrawnThinlyWithLabelsAtTheEdges) {
    const std::array<std::uint8_t, 3> ground = {60, 110, 60};
    const Fonts fonts;
    const Canvas canvas(plain_image(960, 720, ground), fonts);
    scene::Bounds bounds;
    bounds.extend({-100, 0, -100});
    bounds.extend({100, 10, 100});
    Viewpoint view = plan(bounds, 960.0 / 720.0);
    view.height = 144.0;  // five pixels per metre
    draw_map_grid(canvas, view);
    const Image image = canvas.image();
    EXPECT_GT(brightness(image, 480, 300), brightness(image, 470, 300) + 20.0) << "x = 0";
    EXPECT_GT(brightness(image, 530, 360), brightness(image, 530, 350) + 20.0) << "z = 0";
    EXPECT_EQ(image.pixel(530, 300), ground) << "between the lines";
    int drawn = 0;
    for (int y = 60; y < 660; ++y) {
        for (int x = 60; x < 900; ++x) {
            drawn += image.pixel(x, y) != ground ? 1 : 0;
        }
    }
    EXPECT_LT(drawn, 840 * 600 / 12) << "most of the picture is as it was";
    int label = 0;  // the 0 on the lower edge
    for (int y = 704; y < 719; ++y) {
        for (int x = 470; x < 490; ++x) {
            label += brightness(image, x, y) > 190.0 ? 1 : 0;
        }
    }
    EXPECT_GT(label, 10);
}

}  // namespace
}  // namespace campuswalk::engine::render::test
