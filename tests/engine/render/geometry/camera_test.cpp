#include "engine/render/geometry/camera.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render {
namespace {

using Eigen::Vector3d;
using test::avatar_at;

constexpr double kPi = 3.141592653589793;
constexpr double kFov = kPi / 3.0;
// Half of 720 pixels over the tangent of 30 degrees.
const double kFocalPixels = 360.0 * std::sqrt(3.0);

void expect_pixel(const Viewpoint& view, const Vector3d& point, double x, double y) {
    const auto pixel = pixel_of(view, 1280, 720, point);
    ASSERT_TRUE(pixel) << point.transpose();
    EXPECT_NEAR(pixel->x(), x, 1e-6) << point.transpose();
    EXPECT_NEAR(pixel->y(), y, 1e-6) << point.transpose();
}

TEST(FirstPerson, LooksFromTheEyesAlongTheHeading) {
    AvatarProfile profile;
    profile.eye_height = 1.5;
    const Viewpoint north = first_person(avatar_at({3, 1, -2}, 0.0), profile, kFov);
    EXPECT_TRUE(north.position.isApprox(Vector3d(3, 2.5, -2)));
    expect_pixel(north, {3, 2.5, -12}, 640, 360);
    expect_pixel(north, {4, 2.5, -12}, 640 + 0.1 * kFocalPixels, 360);
    expect_pixel(north, {3, 3.5, -12}, 640, 360 - 0.1 * kFocalPixels);
    EXPECT_FALSE(pixel_of(north, 1280, 720, {3, 2.5, 8})) << "behind the camera";
}

TEST(FirstPerson, PositiveYawTurnsLeftAndPositivePitchUp) {
    const AvatarProfile profile;
    const Viewpoint west = first_person(avatar_at({0, 0, 0}, 0.5 * kPi), profile, kFov);
    expect_pixel(west, {-10, profile.eye_height, 0}, 640, 360);
    expect_pixel(west, {-10, profile.eye_height, -1}, 640 + 0.1 * kFocalPixels,
                 360);  // north is on the right
    const Viewpoint up = first_person(avatar_at({0, 0, 0}, 0.0, 0.3), profile, kFov);
    expect_pixel(up, {0, profile.eye_height + 10 * std::sin(0.3), -10 * std::cos(0.3)}, 640, 360);
}

TEST(ThirdPerson, StandsBehindAndLooksDownAtTheAvatar) {
    AvatarProfile profile;
    profile.eye_height = 1.65;
    const Viewpoint view = third_person(avatar_at({1, 0, 2}, 0.0), profile, kFov, 4.0, {});
    // 1.8 m up, then 4 m back along a line that falls by 0.17 rad.
    EXPECT_NEAR(view.position.x(), 1.0, 1e-12);
    EXPECT_NEAR(view.position.y(), 1.8 + 4.0 * std::sin(0.17), 1e-12);
    EXPECT_NEAR(view.position.z(), 2.0 + 4.0 * std::cos(0.17), 1e-12);
    expect_pixel(view, {1, 1.8, 2}, 640, 360);
}

TEST(ThirdPerson, ComesCloserIfAWallIsBehind) {
    const AvatarProfile profile;
    const AvatarState avatar = avatar_at({0, 0, 0}, 0.4);
    const auto distance_with = [&](double free) {
        const auto view = third_person(
            avatar, profile, kFov, 4.0,
            [free](const Vector3d& from, const Vector3d& to) { return std::min(free, (to - from).norm()); });
        return (view.position - Vector3d(0, profile.eye_height + 0.15, 0)).norm();
    };
    EXPECT_NEAR(distance_with(100.0), 4.0, 1e-12);
    EXPECT_NEAR(distance_with(2.0), 1.75, 1e-12);
    EXPECT_NEAR(distance_with(0.32), 0.288, 1e-12) << "on this side of the wall";
}

TEST(ThirdPerson, StaysOnThisSideOfWhatIsNearerThanTheHead) {
    AvatarState avatar;
    AvatarProfile mouse;
    mouse.height = 0.2;
    mouse.eye_height = 0.18;
    // A ceiling 3 cm above its eyes, and a wall 4 cm behind.
    const auto free = [](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
        return std::min((to - from).norm(), to.y() - from.y() > 0.1 ? 0.03 : 0.04);
    };
    const Viewpoint view = third_person(avatar, mouse, 1.0, 4.0, free);
    EXPECT_LT(view.position.y(), 0.18 + 0.03);
    EXPECT_LT(view.position.z(), 0.04);
}

TEST(NearPlane, IsWithinTheFreeSpace) {
    for (const double fov_deg : {20.0, 60.0, 120.0, 170.0}) {
        for (const double free : {0.5, 0.1, 0.03, 0.002}) {
            for (const double aspect : {0.5, 1.0, 16.0 / 9.0, 8.0}) {
                Viewpoint view = looking({1, 2, 3}, 0.3, -0.2, fov_deg * M_PI / 180.0);
                keep_near_plane_free(view, aspect, [free](const Eigen::Vector3d&, double most) {
                    return std::min(free, most);
                });
                const Eigen::Matrix4d world_clip = clip_from_world(view, aspect).inverse();
                const Eigen::Vector4d farthest = world_clip * Eigen::Vector4d(1, 1, 1, 1);
                const double distance = (farthest.head<3>() / farthest.w() - view.position).norm();
                EXPECT_LE(distance, free * (1.0 + 1e-9)) << fov_deg << " degrees, " << aspect;
                EXPECT_LE(view.near_distance, 0.1);
            }
        }
    }
    Viewpoint roomy = looking({1, 2, 3}, 0, 0, 1.0);
    keep_near_plane_free(roomy, 1.5, [](const Eigen::Vector3d&, double most) { return most; });
    EXPECT_EQ(roomy.near_distance, 0.1);
    Viewpoint map = plan(scene::Bounds{{0, 0, 0}, {9, 9, 9}}, 1.5);
    keep_near_plane_free(map, 1.5, [](const Eigen::Vector3d&, double) { return 0.0; });
    EXPECT_EQ(map.near_distance, 0.0);
}

TEST(TopView, IsAMapWithNorthUpCentredOnAGroundPoint) {
    scene::Bounds campus;
    campus.extend({-50, -2, -50});
    campus.extend({50, 30, 50});
    // 90 degrees from 40 m up: 80 m from edge to edge.
    const Viewpoint view = top({10, 1, 20}, 40.0, 0.5 * kPi, campus);
    EXPECT_EQ(view.projection, Projection::orthographic);
    EXPECT_NEAR(view.height, 80.0, 1e-9);
    expect_pixel(view, {10, 1, 20}, 640, 360);
    expect_pixel(view, {10, 25, 20}, 640, 360);  // height does not matter on a map
    expect_pixel(view, {11, 1, 20}, 649, 360);   // east is right
    expect_pixel(view, {10, 1, 19}, 640, 351);   // north is up
    EXPECT_GT(view.position.y(), campus.max.y());
    EXPECT_TRUE(pixel_of(view, 1280, 720, {10, 30, 20})) << "the highest roof is in front of the camera";
}

TEST(PlanView, FitsTheWholeCampusAtAnyAspectRatio) {
    scene::Bounds campus;
    campus.extend({-120, -2, -40});
    campus.extend({80, 30, 60});
    for (const auto& [width, height] : {std::pair(1280, 720), std::pair(300, 900), std::pair(64, 64)}) {
        const Viewpoint view = plan(campus, static_cast<double>(width) / height);
        for (const double x : {campus.min.x(), campus.max.x()}) {
            for (const double z : {campus.min.z(), campus.max.z()}) {
                const auto pixel = pixel_of(view, width, height, {x, 0, z});
                ASSERT_TRUE(pixel);
                EXPECT_GT(pixel->x(), 0);
                EXPECT_LT(pixel->x(), width);
                EXPECT_GT(pixel->y(), 0);
                EXPECT_LT(pixel->y(), height);
            }
        }
    }
}

TEST(PlanView, IsValidForAnEmptyCampus) {
    const Viewpoint view = plan({}, 1.5);
    EXPECT_GT(view.height, 0.0);
    EXPECT_TRUE(clip_from_world(view, 1.5).allFinite());
}

TEST(ClipFromWorld, DepthFallsFromOneAtTheNearPlaneTowardsZero) {
    Viewpoint view = looking({0, 0, 0}, 0.0, 0.0, kFov);
    view.near_distance = 0.1;
    const auto depth = [&](double distance) {
        const Eigen::Vector4d clip = clip_from_world(view, 1.5) * Eigen::Vector4d(0, 0, -distance, 1);
        return clip.z() / clip.w();
    };
    EXPECT_NEAR(depth(0.1), 1.0, 1e-12);
    EXPECT_NEAR(depth(1.0), 0.1, 1e-12);
    EXPECT_NEAR(depth(1000.0), 0.0001, 1e-12);
}

TEST(ClipFromWorld, PreservesTheAspectRatioOfSquares) {
    const Viewpoint view = looking({0, 0, 0}, 0.0, 0.0, kFov);
    const auto right = pixel_of(view, 1600, 400, {1, 0, -5});
    const auto above = pixel_of(view, 1600, 400, {0, 1, -5});
    ASSERT_TRUE(right && above);
    EXPECT_NEAR(right->x() - 800.0, 200.0 - above->y(), 1e-9);
}

TEST(Camera, LookingAtPutsTheTargetInTheMiddle) {
    for (const Vector3d& target : {Vector3d(3, 1, -4), Vector3d(-8, 20, 5), Vector3d(2, -7, 2)}) {
        const Viewpoint view = looking_at({2, 1.5, 2}, target, 1.0);
        const auto pixel = pixel_of(view, 200, 100, target);
        ASSERT_TRUE(pixel);
        EXPECT_NEAR(pixel->x(), 100.0, 1e-9);
        EXPECT_NEAR(pixel->y(), 50.0, 1e-9);
        EXPECT_NEAR(view.R_world_camera.col(0).y(), 0.0, 1e-12) << "no roll";
    }
}

TEST(Camera, OrbitingAPointKeepsItsDistanceAndDirection) {
    const Viewpoint view = orbiting({5, 1, 5}, 7.0, -0.5, -0.4, 1.0);
    EXPECT_NEAR((view.position - Vector3d(5, 1, 5)).norm(), 7.0, 1e-12);
    EXPECT_GT(view.position.y(), 1.0) << "looks down from above";
    const auto pixel = pixel_of(view, 200, 100, {5, 1, 5});
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x(), 100.0, 1e-9);
    EXPECT_NEAR(pixel->y(), 50.0, 1e-9);
}

TEST(Camera, OrbitingABoxShowsAllOfItAndLittleElse) {
    scene::Bounds box;
    box.extend({-20, 0, 3});
    box.extend({10, 6, 15});
    for (const double aspect : {0.5, 1.0, 2.0}) {
        for (const double yaw : {-2.0, -0.5, 0.0, 1.5}) {
            const auto width = static_cast<int>(400 * aspect);
            const Viewpoint view = orbiting(box, aspect, yaw, -0.4, 1.0);
            double widest = 0.0;
            for (int i = 0; i < 8; ++i) {
                const Vector3d vertex((i & 1) != 0 ? 10 : -20, (i & 2) != 0 ? 6 : 0, (i & 4) != 0 ? 15 : 3);
                const auto pixel = pixel_of(view, width, 400, vertex);
                ASSERT_TRUE(pixel);
                widest =
                    std::max({widest, std::abs(pixel->x() / width - 0.5), std::abs(pixel->y() / 400 - 0.5)});
            }
            EXPECT_LT(widest, 0.5) << "aspect " << aspect << ", yaw " << yaw;
            EXPECT_GT(widest, 0.44) << "aspect " << aspect << ", yaw " << yaw;
        }
    }
}

}  // namespace
}  // namespace campuswalk::engine::render
