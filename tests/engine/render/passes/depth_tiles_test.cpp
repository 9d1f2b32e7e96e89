#include "engine/render/passes/depth_tiles.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/render/geometry/camera.h"
#include "tests/support/dice.h"

namespace campuswalk::engine::render::test {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr int kWide = 100;  // pixels: neither is a whole number of tiles
constexpr int kHigh = 58;

Eigen::Matrix4d clip_campus() {
    return clip_from_world(looking(Vector3d::Zero(), 0.0, 0.0, 1.0), static_cast<double>(kWide) / kHigh);
}

double depth_at(double distance) {
    const Eigen::Vector4d clip = clip_campus() * Eigen::Vector4d(0, 0, -distance, 1);
    return clip.z() / clip.w();
}

DepthTiles everywhere(double distance) {
    DepthTiles tiles;
    tiles.columns = (kWide + DepthTiles::kTileWidth - 1) / DepthTiles::kTileWidth;
    tiles.rows = (kHigh + DepthTiles::kTileHeight - 1) / DepthTiles::kTileHeight;
    tiles.farthest.assign(static_cast<std::size_t>(tiles.columns) * static_cast<std::size_t>(tiles.rows),
                          static_cast<float>(depth_at(distance)));
    return tiles;
}

AlignedBox3d box_at(const Vector3d& middle, double half) {
    return {Vector3d(middle.array() - half), Vector3d(middle.array() + half)};
}

bool occludes(const DepthTiles& tiles, const AlignedBox3d& box) {
    return tiles.occlude(box, clip_campus(), kWide, kHigh);
}

TEST(DepthTiles, OccludeOnlyWhatIsBehind) {
    const DepthTiles tiles = everywhere(10.0);
    EXPECT_TRUE(occludes(tiles, box_at({0, 0, -12}, 1.0)));
    EXPECT_FALSE(occludes(tiles, box_at({0, 0, -10.5}, 1.0))) << "reaches through";
    EXPECT_FALSE(occludes(tiles, box_at({0, 0, -11}, 1.0))) << "touches";
    EXPECT_FALSE(occludes(tiles, box_at({0, 0, -5}, 1.0))) << "in front";
    EXPECT_FALSE(occludes(tiles, box_at({0, 0, 0}, 30.0))) << "all around";
    EXPECT_FALSE(occludes(tiles, box_at({0, 0, 20}, 1.0))) << "behind the camera";
    EXPECT_FALSE(tiles.empty());
    EXPECT_TRUE(DepthTiles().empty());
}

TEST(DepthTiles, OneOpenTilePreventsOcclusion) {
    DepthTiles tiles = everywhere(10.0);
    const int middle = tiles.rows / 2 * tiles.columns + tiles.columns / 2;
    tiles.farthest[static_cast<std::size_t>(middle)] = 0.0F;  // the sky
    EXPECT_FALSE(occludes(tiles, box_at({0, 0, -12}, 1.0)));
    EXPECT_TRUE(occludes(tiles, box_at({-6, 0, -12}, 1.0))) << "beside it";
}

// Tests random points of the box against the depth at their pixel.
TEST(DepthTiles, OccludedBoxesHaveNoPointInFront) {
    support::Dice dice(5);
    int hidden = 0;
    for (int i = 0; i < 3000; ++i) {
        DepthTiles tiles = everywhere(20.0);
        for (float& depth : tiles.farthest) {
            depth = static_cast<float>(depth_at(dice.between(4.0, 40.0)));
        }
        const AlignedBox3d box = box_at({dice.between(-20, 20), dice.between(-10, 10), -dice.between(3, 60)},
                                        dice.between(0.05, 2.0));
        if (!occludes(tiles, box)) {
            continue;
        }
        ++hidden;
        for (int k = 0; k < 50; ++k) {
            const Vector3d at =
                box.min() + Vector3d(dice.between(0, 1), dice.between(0, 1), dice.between(0, 1))
                                .cwiseProduct(box.sizes());
            const Eigen::Vector4d clip = clip_campus() * at.homogeneous();
            const double x = 0.5 * kWide * (clip.x() / clip.w() + 1.0);
            const double y = 0.5 * kHigh * (clip.y() / clip.w() + 1.0);
            if (x < 0.0 || y < 0.0 || x >= kWide || y >= kHigh) {
                continue;
            }
            const int tile = static_cast<int>(y) / DepthTiles::kTileHeight * tiles.columns +
                             static_cast<int>(x) / DepthTiles::kTileWidth;
            ASSERT_LT(clip.z() / clip.w(), tiles.farthest[static_cast<std::size_t>(tile)]);
        }
    }
    EXPECT_GT(hidden, 300);
    EXPECT_LT(hidden, 2700);
}

}  // namespace
}  // namespace campuswalk::engine::render::test
