// A hall: rooms with doors, a room without, and stairs to the upper floor.

#include <numbers>

#include "tools/campuswalk_bench/procedural/campus_parts.h"
#include "tools/campuswalk_bench/procedural/course_ground.h"

namespace campuswalk::tools::bench {

using collision::Pose;
using collision::Vec3;

namespace {

// From x = -kHalf to kHalf and from z = -kDepth to the front at 0.
constexpr double kHalf = 9.0;
constexpr double kDepth = 12.0;
constexpr double kThickness = 0.2;  ///< of walls
constexpr double kFloor = 0.15;     ///< above the ground
constexpr int kRisers = 20;
constexpr double kRiser = 0.16;
constexpr double kTread = 0.28;
constexpr double kUpper = kFloor + kRisers * kRiser;  ///< the upper floor
constexpr double kUnder = kUpper - 0.2;               ///< its underside
constexpr double kStairsFoot = -7.5;                  ///< x of the first riser
constexpr double kStairsTop = kStairsFoot + (kRisers - 1) * kTread;
constexpr double kStairsFront = -10.6;  ///< z of their open side

/// A wall along x with a door in its middle.
void add_front(const CourseGround& ground) {
    const double jamb = 0.5 * ground.sizes.door;
    ground.add_box({-kHalf, -0.5, -kThickness}, {-jamb, kUnder, 0.0});
    ground.add_box({jamb, -0.5, -kThickness}, {kHalf, kUnder, 0.0});
    ground.add_box({-jamb, kFloor + 2.05, -kThickness}, {jamb, kUnder, 0.0});
}

void add_ground_floor(const CourseGround& ground) {
    ground.add_box({-kHalf, -0.5, -kDepth}, {kHalf, kFloor, 0.0});
    add_front(ground);
    ground.add_box({-kHalf, -0.5, -kDepth}, {kHalf, kUpper, kThickness - kDepth});
    ground.add_box({-kHalf, -0.5, kThickness - kDepth}, {kThickness - kHalf, kUpper, -kThickness});
    ground.add_box({kHalf - kThickness, -0.5, kThickness - kDepth}, {kHalf, kUnder, -kThickness});
    // A room behind a door.
    const double jamb = 0.5 * ground.sizes.door;
    ground.add_box({2.9, kFloor, kThickness - kDepth}, {3.1, kUnder, -6.0 - jamb});
    ground.add_box({2.9, kFloor, -6.0 + jamb}, {3.1, kUnder, -kThickness});
    ground.add_box({2.9, kFloor + 2.0, -6.0 - jamb}, {3.1, kUnder, -6.0 + jamb});
    // A closed room.
    ground.add_box({-5.1, kFloor, -4.6}, {-5.0, kUnder, -kThickness});
    ground.add_box({kThickness - kHalf, kFloor, -4.7}, {-5.0, kUnder, -4.6});
}

void add_stairs(const CourseGround& ground) {
    for (int i = 0; i + 1 < kRisers; ++i) {
        const double y = kFloor + kRiser * i;
        ground.add_box({kStairsFoot + kTread * i, y, kThickness - kDepth},
                       {kStairsTop, y + kRiser, kStairsFront});
    }
}

void add_upper_floors(const CourseGround& ground) {
    ground.add_box({kStairsTop, kUnder, -kDepth}, {kHalf, kUpper, 0.0});
    ground.add_box({-kHalf, kUnder, kStairsFront + 0.1}, {kStairsTop, kUpper, 0.0});
    // A parapet along the stairs.
    ground.add_box({-8.7, kUpper, kStairsFront + 0.1}, {kStairsTop - 0.8, kUpper + 1.0, kStairsFront + 0.15});
    const int storeys = ground.sizes.storeys_above_ground;
    for (int side = 0; side < 4; ++side) {
        const bool is_long = side % 2 == 0;
        const Pose X_hall_wall = pose_with_yaw(Vec3::Zero(), 0.5 * std::numbers::pi * side);
        const Vec3 middle =
            Vec3(0.0, kUpper, -0.5 * kDepth) + X_hall_wall.rotate({0.0, 0.0, is_long ? 0.5 * kDepth : kHalf});
        const Pose X{ground.X.rotation * X_hall_wall.rotation, ground.X * middle};
        add_window_wall(ground.parts, X, is_long ? kHalf : 0.5 * kDepth, storeys);
    }
    for (int storey = 1; storey <= storeys; ++storey) {
        const double y = kUpper + kStorey * storey;
        ground.add_box({-kHalf, y - 0.2, -kDepth}, {kHalf, y, 0.0});
    }
}

}  // namespace

void add_hall(const CourseGround& ground) {
    add_ground_floor(ground);
    add_stairs(ground);
    add_upper_floors(ground);
    const double on_stairs = 0.5 * (kThickness - kDepth + kStairsFront);
    const Vec3 foot(-8.2, kFloor, on_stairs);
    const Vec3 before_foot(-8.2, kFloor, -8.5);
    const Vec3 top(kStairsTop + 1.0, kUpper, on_stairs);
    ground.add_path("doors", {0.0, 0.0, 5.0},
                    {{0.0, kFloor, -2.5}, {1.6, kFloor, -6.0}, {6.0, kFloor, -6.0}, {6.0, kFloor, -1.5}});
    ground.add_path("stairs up", {-3.0, kFloor, -7.0}, {before_foot, foot, top, {6.0, kUpper, -4.0}});
    ground.add_path("stairs down", {2.0, kUpper, -8.0}, {top, foot, before_foot, {-3.0, kFloor, -6.0}});
    ground.add_path("closed room", {-3.0, kFloor, -2.5}, {{-7.0, kFloor, -2.5}}, true);
}

}  // namespace campuswalk::tools::bench
