// Outdoor obstacles to climb, pass and slide along.

#include <numbers>

#include "collision/geometry/trigonometry.h"
#include "tools/campuswalk_bench/procedural/course_ground.h"

namespace campuswalk::tools::bench {

using collision::Vec3;

namespace {

/// Up a ramp and off the far end of the platform.
void add_ramp_and_drop(const CourseGround& ground) {
    constexpr double kTop = 1.5;
    const auto [sin, cos] = collision::sin_cos(std::numbers::pi / 180.0 * ground.sizes.ramp);
    const double foot = -7.0 + kTop * cos / sin;
    ground.add_ramp({13.0, 0.0, foot}, {17.0, kTop, -7.0});
    ground.add_box({13.0, -0.5, -11.0}, {17.0, kTop, -7.0});
    ground.add_path("ramp and drop", {15.0, 0.0, foot + 1.5}, {{15.0, kTop, -9.0}, {15.0, 0.0, -14.0}});
}

void add_kerb(const CourseGround& ground) {
    const double high = ground.sizes.kerb;
    ground.add_box({12.0, -0.5, 7.5}, {16.0, high, 11.5});
    ground.add_path("kerb", {10.0, 0.0, 9.5}, {{14.0, high, 9.5}, {18.0, 0.0, 9.5}});
}

/// Around a post slightly off the path, and through a gate.
void add_post_and_gate(const CourseGround& ground) {
    constexpr double kGate = 9.0;  // z
    ground.parts.add_prism(ground.X, {-15.0, -0.2, 5.8}, 0.07, 4.2, 8);
    ground.add_box({-13.5, -0.5, kGate - 0.1}, {-11.5, 2.6, kGate + 0.1});
    ground.add_box({-10.5, -0.5, kGate - 0.1}, {-8.5, 2.6, kGate + 0.1});
    ground.add_box({-11.5, ground.sizes.gate, kGate - 0.1}, {-10.5, 2.6, kGate + 0.1});
    ground.add_path("post and gate", {-19.0, 0.0, 6.0}, {{-11.0, 0.0, 6.0}, {-11.0, 0.0, 12.0}});
}

/// Along a wall made of pieces; the goal is behind its end, on the other side.
void add_walls_to_slide_along(const CourseGround& ground) {
    for (int piece = 0; piece < 7; ++piece) {
        const double z = -10.0 + piece;
        ground.add_box({-16.1, -0.5, z}, {-15.9, 2.2, z + 1.0});
    }
    ground.add_path("along a wall", {-17.2, 0.0, -10.0}, {{-15.0, 0.0, -1.0}});
}

/// Between two rows of low and high boxes, just wide enough for a person.
void add_alley(const CourseGround& ground) {
    for (int piece = 0; piece < 6; ++piece) {
        const double x = -4.0 + 1.5 * piece;
        const double high = piece % 2 == 0 ? 0.5 : 2.0;
        ground.add_box({x, -0.5, 9.0}, {x + 1.5, high, 9.2});
        ground.add_box({x, -0.5, 9.9}, {x + 1.5, high, 10.1});
    }
    ground.add_path("alley", {-5.5, 0.0, 9.55}, {{6.5, 0.0, 9.55}});
}

}  // namespace

void add_yard(const CourseGround& ground) {
    add_ramp_and_drop(ground);
    add_kerb(ground);
    add_post_and_gate(ground);
    add_walls_to_slide_along(ground);
    add_alley(ground);
}

}  // namespace campuswalk::tools::bench
