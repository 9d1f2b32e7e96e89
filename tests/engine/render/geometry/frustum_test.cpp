#include "engine/render/geometry/frustum.h"

#include <random>

#include <gtest/gtest.h>

#include "engine/render/geometry/camera.h"

namespace campuswalk::engine::render {
namespace {

using Eigen::Vector3d;

bool shows(const Eigen::Matrix4d& clip, const Vector3d& point) {
    const Eigen::Vector4d p = clip * point.homogeneous();
    return std::abs(p.x()) <= p.w() && std::abs(p.y()) <= p.w() && p.z() >= 0.0 && p.z() <= p.w();
}

TEST(Frustum, NeverCullsABoxWithAVisiblePoint) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-20.0, 20.0);
    scene::Bounds campus;
    campus.extend({-20, -20, -20});
    campus.extend({20, 20, 20});
    int visible = 0;
    int culled = 0;
    for (int i = 0; i < 4000; ++i) {
        const Viewpoint view = i % 4 == 0 ? plan(campus, 1.5)
                                          : looking({any(random), any(random), any(random)}, any(random),
                                                    0.05 * any(random), 1.0);
        const Eigen::Matrix4d clip = clip_from_world(view, 1.5);
        const Vector3d vertex(any(random), any(random), any(random));
        Eigen::AlignedBox3d box(vertex);
        box.extend(vertex + Vector3d::Constant(0.2 * std::abs(any(random))));
        const bool may_intersect = Frustum(clip).may_intersect(box);
        for (int k = 0; k < 8; ++k) {
            if (shows(clip, box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k)))) {
                ++visible;
                ASSERT_TRUE(may_intersect) << "view " << i;
            }
        }
        culled += may_intersect ? 0 : 1;
    }
    EXPECT_GT(visible, 1000);
    EXPECT_GT(culled, 1000) << "it culls enough to be useful";
}

TEST(Frustum, CullsBoxesBehindAndBeside) {
    const Frustum frustum(clip_from_world(looking({0, 0, 0}, 0.0, 0.0, 1.0), 1.0));
    const Vector3d half(1, 1, 1);
    const auto box_at = [&](const Vector3d& p) { return Eigen::AlignedBox3d(p - half, p + half); };
    EXPECT_TRUE(frustum.may_intersect(box_at({0, 0, -10})));
    EXPECT_TRUE(frustum.may_intersect(box_at({0, 0, -1e6}))) << "there is no far plane";
    EXPECT_FALSE(frustum.may_intersect(box_at({0, 0, 10})));
    EXPECT_FALSE(frustum.may_intersect(box_at({30, 0, -10})));
    EXPECT_FALSE(frustum.may_intersect(box_at({0, -30, -10})));
}

}  // namespace
}  // namespace campuswalk::engine::render
