#include "engine/render/plan/plan_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "engine/render/plan/plan_style.h"
#include "tests/engine/render/color_names.h"

namespace campuswalk::engine::render::test {
namespace {

using Eigen::Vector2d;

const PlanColor kReached = color_of(PlanCell::reached);
const PlanColor kUnreached = color_of(PlanCell::unreached);
const PlanColor kSolid = color_of(PlanCell::solid);

/// 20 m by 16 m about the origin, half a metre a cell, 20 pixels a metre: everything is reached but the
/// eastern half, which is nothing.
class StoreyPlanImage : public testing::Test {
protected:
    StoreyPlanImage() {
        plan_.area = Eigen::AlignedBox2d(Vector2d(-10, -8), Vector2d(10, 8));
        plan_.metres_per_pixel = 0.05;
        plan_.raster.north_west = {-10, -8};
        plan_.raster.cell_size = 0.5;
        plan_.raster.columns = 40;
        plan_.raster.rows = 32;
        plan_.raster.cells.assign(std::size_t{40} * 32, PlanCell::nothing);
        fill({-10, -8}, {0, 8}, PlanCell::reached);
    }

    void fill(const Vector2d& from, const Vector2d& to, PlanCell cell) {
        each_cell(from, to, [&](std::size_t i) { plan_.raster.cells[i] = cell; });
    }
    void widen(const Vector2d& from, const Vector2d& to, float width) {
        plan_.raster.widths.resize(plan_.raster.cells.size(), -1.0F);
        each_cell(from, to, [&](std::size_t i) { plan_.raster.widths[i] = width; });
    }
    template <typename Visit>
    void each_cell(const Vector2d& from, const Vector2d& to, const Visit& visit) {
        const PlanRaster& raster = plan_.raster;
        for (int row = 0; row < raster.rows; ++row) {
            for (int column = 0; column < raster.columns; ++column) {
                const Vector2d middle =
                    raster.north_west + raster.cell_size * Vector2d(column + 0.5, row + 0.5);
                if ((middle.array() > from.array()).all() && (middle.array() < to.array()).all()) {
                    const int cell = row * raster.columns + column;
                    visit(static_cast<std::size_t>(cell));
                }
            }
        }
    }

    /// The first pixel of the map in the image: its frame starts one pixel above and left of it.
    Vector2d map_start(const Image& image) const {
        for (int y = 40; y < image.height; ++y) {
            int run = 0;
            for (int x = 0; x < image.width; ++x) {
                run = brightness(image, x, y) < 130.0 ? run + 1 : 0;
                if (run > 400) {
                    return {x - run + 2, y + 1};
                }
            }
        }
        ADD_FAILURE() << "no frame";
        return Vector2d::Zero();
    }
    PlanColor at(const Image& image, double x, double z) const {
        const Vector2d pixel =
            map_start(image) + (Vector2d(x, z) - plan_.area.min()) / *plan_.metres_per_pixel;
        return image.pixel(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
    }
    /// How many pixels within `radius` metres have this colour.
    int count(const Image& image, const PlanColor& color, const Vector2d& middle, double radius) const {
        const auto side = static_cast<int>(std::floor(2.0 * radius / *plan_.metres_per_pixel)) + 1;
        int pixels = 0;
        for (int column = 0; column < side; ++column) {
            for (int row = 0; row < side; ++row) {
                const Vector2d place =
                    middle.array() - radius + *plan_.metres_per_pixel * Vector2d(column, row).array();
                pixels += at(image, place.x(), place.y()) == color ? 1 : 0;
            }
        }
        return pixels;
    }

    StoreyPlan plan_;
};

TEST_F(StoreyPlanImage, CellsAreWhereTheyAreInTheWorld) {
    fill({-8, -6}, {-6, -4}, PlanCell::unreached);
    fill({4, 2}, {6, 3}, PlanCell::solid);
    const Image image = draw_storey_plan(plan_);
    EXPECT_EQ(at(image, -3.3, 3.3), kReached);
    EXPECT_EQ(at(image, 3.3, 3.3), kPaper);
    EXPECT_EQ(at(image, -7.7, -5.7), kUnreached);
    EXPECT_EQ(at(image, -6.3, -4.3), kUnreached);
    EXPECT_EQ(at(image, -5.7, -4.3), kReached);
    EXPECT_EQ(at(image, 4.1, 2.1), kSolid);
    EXPECT_EQ(at(image, 5.9, 2.9), kSolid);
    EXPECT_EQ(at(image, 5.9, 3.1), kPaper);
    EXPECT_LT(brightness(image, static_cast<int>(map_start(image).x()) + 199,
                         static_cast<int>(map_start(image).y()) + 30),
              120.0)
        << "the rim of walkable ground";
}

TEST_F(StoreyPlanImage, CellsWithoutReturnAreStriped) {
    fill({-8, -6}, {-4, -2}, PlanCell::no_return);
    const Image image = draw_storey_plan(plan_);
    const int stripes = count(image, kNoReturnStripe, {-6.6, -3.4}, 0.5);
    EXPECT_NEAR(stripes, 0.375 * 21 * 21, 20);
    EXPECT_EQ(count(image, kNoReturnStripe, {-1.5, 3.5}, 0.5), 0);
}

TEST_F(StoreyPlanImage, AnArrowAtTheBorderPointsToWhatIsFartherAway) {
    plan_.points = {{{500, 3}, "stray", PlanPointKind::place}};
    plan_.findings = {{1, {-3, -500}, "far north", PlanSeverity::error}};
    const Image image = draw_storey_plan(plan_);
    for (const Vector2d& middle : {Vector2d(9.7, 3), Vector2d(-3, -7.7)}) {
        const PlanColor arrow = at(image, middle.x(), middle.y());
        EXPECT_LT(static_cast<int>(arrow[0]) + arrow[1] + arrow[2], 150) << middle.transpose();
    }
}

TEST_F(StoreyPlanImage, WidthsColorWhatIsReached) {
    fill({-8, -6}, {-6, -4}, PlanCell::unreached);
    widen({-10, -8}, {-2.5, 8}, 0.5F);
    widen({-5, 0}, {-2.5, 8}, 9.0F);
    plan_.narrowest = 0.2;
    plan_.widest = 1.4;
    const Image image = draw_storey_plan(plan_);
    EXPECT_EQ(at(image, -7.3, 3.3), width_color(0.25));
    EXPECT_EQ(at(image, -3.3, 3.3), kReached) << "wide enough";
    EXPECT_EQ(at(image, -1.3, 3.3), kReached) << "unknown width";
    EXPECT_EQ(at(image, -7.3, -5.3), kUnreached);
    EXPECT_EQ(width_color(-1.0), width_color(0.0));
    EXPECT_EQ(width_color(2.0), width_color(1.0));
}

TEST_F(StoreyPlanImage, PixelsOfSeveralCellsHaveTheKindOfMost) {
    plan_.metres_per_pixel = 2.0;  // 16 cells a pixel
    plan_.area = Eigen::AlignedBox2d(Vector2d(-1000, -800), Vector2d(1000, 800));
    fill({-6, -4}, {-4, -2}, PlanCell::unreached);
    fill({-6, -4}, {-5.5, -2}, PlanCell::no_return);
    const Image image = draw_storey_plan(plan_);
    EXPECT_EQ(at(image, -5, -3), kUnreached);
    EXPECT_EQ(at(image, -3, 3), kReached);
    EXPECT_EQ(at(image, -50, 3), kPaper) << "outside of the raster";
}

TEST_F(StoreyPlanImage, FindingsAreNumberedMarkers) {
    const Image bare = draw_storey_plan(plan_);
    plan_.findings = {{7, {-5, 3}, "trap", PlanSeverity::error},
                      {8, {-5, 3.1}, "stuck", PlanSeverity::warning}};
    const Image image = draw_storey_plan(plan_);
    const PlanColor red = at(image, -5.35, 3);
    EXPECT_GT(red[0], 2 * red[1]);
    EXPECT_GT(count(image, red, {-5, 3}, 0.6), 150);
    EXPECT_GE(count(image, {255, 255, 255}, {-5, 3}, 0.3), 5) << "its number";
    // The other marker has moved aside.
    EXPECT_GT(count(image, {255, 222, 64}, {-5, 3}, 2.0), 150);
    EXPECT_EQ(count(image, {255, 222, 64}, {-5, 3}, 0.5), 0);
    EXPECT_GT(image.height, bare.height + 30) << "the list";
    plan_.findings.resize(1);
    plan_.findings[0].text = "hole";
    EXPECT_NE(draw_storey_plan(plan_).rgba, image.rgba);
}

TEST_F(StoreyPlanImage, PointsAndRoutesAreDrawn) {
    const Image bare = draw_storey_plan(plan_);
    plan_.points = {{{-7, 2}, "gate", PlanPointKind::spawn}, {{-3, -4}, "hall", PlanPointKind::place}};
    const Image points = draw_storey_plan(plan_);
    const PlanColor spawn = at(points, -7, 2);
    EXPECT_LT(spawn[0], 60) << "filled";
    EXPECT_EQ(at(points, -3, -4), (PlanColor{255, 255, 255})) << "hollow";
    EXPECT_LT(count(points, kReached, {-6, 2}, 0.5), count(bare, kReached, {-6, 2}, 0.5) - 60) << "its name";
    plan_.routes = {{"gate to hall", {{{-7, 2}, {-7, -4}, {-3, -4}}}}};
    const Image routes = draw_storey_plan(plan_);
    for (const Vector2d& on : {Vector2d(-7, -1.3), Vector2d(-5.2, -4)}) {
        const PlanColor line = at(routes, on.x(), on.y());
        EXPECT_LT(line[1], 60) << on.transpose();
        EXPECT_EQ(at(points, on.x(), on.y()), kReached);
    }
}

TEST_F(StoreyPlanImage, BuildingsHaveTheirNamesWhereThereIsRoom) {
    const auto has_ink = [&](const Image& image, double x, double z) {
        for (int i = -20; i <= 20; ++i) {
            for (int k = -3; k <= 3; ++k) {
                const PlanColor pixel = at(image, x + 0.05 * i, z + 0.05 * k);
                if (pixel[0] < 150 && pixel[1] < 150 && pixel[2] < 150) {
                    return true;
                }
            }
        }
        return false;
    };
    EXPECT_FALSE(has_ink(draw_storey_plan(plan_), 5.3, -2.3));
    plan_.buildings = {{{5.3, -2.3}, "Library"}};
    EXPECT_TRUE(has_ink(draw_storey_plan(plan_), 5.3, -2.3)) << "on paper";
    plan_.buildings = {{{-5.3, -2.3}, "Library"}, {{-5.3, -2.3}, "Annex"}};
    EXPECT_TRUE(has_ink(draw_storey_plan(plan_), -5.3, -2.3)) << "on ground";
    EXPECT_TRUE(has_ink(draw_storey_plan(plan_), -5.3, -3.4)) << "moved aside";
    plan_.buildings = {{{5.3, -2.3}, std::string(200, 'x')}};
    EXPECT_FALSE(has_ink(draw_storey_plan(plan_), 5.3, -2.3)) << "wider than the plan";
}

TEST_F(StoreyPlanImage, TheSamePlanGivesTheSameImage) {
    plan_.title = "demo, storey 1 of 2";
    plan_.points = {{{-7, 2}, "gate", PlanPointKind::spawn}};
    plan_.findings = {{1, {-5, 3}, "trap", PlanSeverity::error}};
    const Image image = draw_storey_plan(plan_);
    EXPECT_EQ(draw_storey_plan(plan_).rgba, image.rgba);
    plan_.metres_per_pixel = {};
    const Image fitted = draw_storey_plan(plan_);
    plan_.metres_per_pixel = round_resolution(plan_.area);
    EXPECT_EQ(draw_storey_plan(plan_).rgba, fitted.rgba);
    EXPECT_EQ(image.rgba.size(),
              4U * static_cast<unsigned>(image.width) * static_cast<unsigned>(image.height));
}

TEST_F(StoreyPlanImage, SeveralPlansAreOneBelowTheOther) {
    StoreyPlan wide = plan_;
    wide.area.extend(Vector2d(30, 0));
    const Image first = draw_storey_plan(plan_);
    const Image second = draw_storey_plan(wide);
    const Image both = draw_storey_plans(std::array{plan_, wide});
    ASSERT_EQ(both.width, second.width);
    ASSERT_EQ(both.height, first.height + second.height);
    EXPECT_TRUE(std::equal(second.rgba.begin(), second.rgba.end(), &both.rgba[both.offset(0, first.height)]));
    EXPECT_EQ(both.pixel(150, 150), first.pixel(150, 150));
    EXPECT_EQ(both.pixel(both.width - 1, 150), kPaper) << "beside the narrower one";
}

TEST_F(StoreyPlanImage, TheLegendIsRightOfANarrowMap) {
    plan_.findings = {{1, {-5, 3}, "trap", PlanSeverity::error}};
    const int below = draw_storey_plan(plan_).height;
    plan_.area = Eigen::AlignedBox2d(Vector2d(-10, -8), Vector2d(-4, 8));  // the same height
    const Image image = draw_storey_plan(plan_);
    EXPECT_LT(image.height, below - 50);
    EXPECT_LT(mean_brightness(image, 220, 50, image.width, 200), 254.0) << "there";
}

TEST_F(StoreyPlanImage, AnEmptyStoreyIsDrawn) {
    plan_.raster = {};
    EXPECT_EQ(at(draw_storey_plan(plan_), -3.3, 3.3), kPaper);
}

TEST(RoundResolution, FitsTheScreen) {
    for (int i = 0; i <= 40; ++i) {
        const double side = 0.5 * std::pow(1.3, i);
        for (const Vector2d& size : {Vector2d(side, 0.4 * side), Vector2d(0.1 * side, side)}) {
            const double resolution = round_resolution({Vector2d(-7, 3), Vector2d(Vector2d(-7, 3) + size)});
            EXPECT_GE(side / resolution, 839.0) << side;
            EXPECT_LE(side / resolution, 2101.0) << side;
            const double power = std::log10(1.0 / resolution);
            const double digit = std::pow(10.0, power - std::floor(power + 1e-9));
            EXPECT_LT(std::min({std::abs(digit - 1), std::abs(digit - 2), std::abs(digit - 5)}), 1e-6)
                << side;
        }
    }
}

}  // namespace
}  // namespace campuswalk::engine::render::test
