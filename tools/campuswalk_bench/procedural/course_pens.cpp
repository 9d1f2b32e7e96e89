// Six pens side by side that cannot be entered, each for a different reason.

#include <numbers>

#include "collision/geometry/trigonometry.h"
#include "tools/campuswalk_bench/procedural/course_ground.h"

namespace campuswalk::tools::bench {

using collision::Vec3;

namespace {

constexpr double kFront = 14.5;  ///< z
constexpr double kBack = 18.0;
constexpr double kHalfPen = 1.7;  ///< along x
constexpr double kHeight = 2.3;   ///< walls
constexpr double kPlateau = 1.5;  ///< high

/// A pen centred at x.
struct Pen {
    const CourseGround& ground;
    double x = 0.0;

    void add_sides() const {
        ground.add_box({x - kHalfPen, -0.5, kFront}, {x - kHalfPen + 0.1, kHeight, kBack});
        ground.add_box({x + kHalfPen - 0.1, -0.5, kFront}, {x + kHalfPen, kHeight, kBack});
        ground.add_box({x - kHalfPen, -0.5, kBack - 0.1}, {x + kHalfPen, kHeight, kBack});
    }

    /// A piece of the front wall, `thick` metres, or a single quad if 0.
    void add_front(double from, double to, double low, double thick) const {
        if (thick > 0.0) {
            ground.add_box({x + from, low, kFront}, {x + to, kHeight, kFront + thick});
            return;
        }
        const auto at = [&](double side, double y) { return Vec3(ground.X * Vec3(x + side, y, kFront)); };
        ground.parts.add_quad(at(from, low), at(from, kHeight), at(to, kHeight), at(to, low));
    }

    void add_path(const char* name, double height = 0.0, double before = 2.0) const {
        ground.add_path(name, {x, 0.0, kFront - before}, {{x, height, 0.5 * (kFront + kBack)}}, true);
    }
};

void add_walled(const Pen& pen) {
    pen.add_sides();
    pen.add_front(-kHalfPen, kHalfPen, -0.5, pen.ground.sizes.wall);
    pen.add_path("wall");
}

void add_riser(const Pen& pen) {
    const double high = pen.ground.sizes.too_high;
    pen.ground.add_box({pen.x - kHalfPen, -0.5, kFront}, {pen.x + kHalfPen, high, kBack});
    pen.add_path("riser too high", high);
}

void add_slope(const Pen& pen) {
    const auto [sin, cos] = collision::sin_cos(std::numbers::pi / 180.0 * pen.ground.sizes.too_steep);
    const double run = kPlateau * cos / sin;
    pen.ground.add_box({pen.x - kHalfPen, -0.5, kFront}, {pen.x + kHalfPen, kPlateau, kBack});
    pen.ground.add_ramp({pen.x - kHalfPen, 0.0, kFront - run}, {pen.x + kHalfPen, kPlateau, kFront});
    pen.add_path("slope too steep", kPlateau, run + 1.0);
}

void add_gap(const Pen& pen) {
    const double half = 0.5 * pen.ground.sizes.too_narrow;
    pen.add_sides();
    pen.add_front(-kHalfPen, -half, -0.5, 0.2);
    pen.add_front(half, kHalfPen, -0.5, 0.2);
    pen.add_path("gap too narrow");
}

void add_low_opening(const Pen& pen) {
    pen.add_sides();
    pen.add_front(-kHalfPen, -0.6, -0.5, 0.2);
    pen.add_front(0.6, kHalfPen, -0.5, 0.2);
    pen.add_front(-0.6, 0.6, pen.ground.sizes.too_low, 0.2);
    pen.add_path("opening too low");
}

void add_bars(const Pen& pen) {
    constexpr double kApart = 0.48;
    pen.add_sides();
    for (int i = -3; i <= 3; ++i) {
        pen.ground.parts.add_prism(pen.ground.X, {pen.x + kApart * i, -0.2, kFront + 0.1}, 0.03, 2.5, 8);
    }
    pen.add_path("bars");
}

}  // namespace

void add_pens(const CourseGround& ground) {
    constexpr void (*kPens[])(const Pen&) = {add_walled, add_riser,       add_slope,
                                             add_gap,    add_low_opening, add_bars};
    double x = -12.5;
    for (const auto& add : kPens) {
        add({ground, x});
        x += 5.0;
    }
}

}  // namespace campuswalk::tools::bench
