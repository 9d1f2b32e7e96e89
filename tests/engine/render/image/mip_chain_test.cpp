#include "engine/render/image/mip_chain.h"

#include <gtest/gtest.h>

namespace campuswalk::engine::render {
namespace {

// About a third of the texels are opaque and green, scattered; the holes are bright red.
scene::Texture leaves(int width, int height) {
    scene::Texture texture;
    texture.width = width;
    texture.height = height;
    texture.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    std::size_t i = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x, i += 4) {
            const bool leaf = (x * 37 + y * 101 + x * y * 13) % 97 < 32;
            texture.rgba[i] = leaf ? 20 : 255;
            texture.rgba[i + 1] = leaf ? 160 : 0;
            texture.rgba[i + 2] = leaf ? 20 : 0;
            texture.rgba[i + 3] = leaf ? 255 : 0;
        }
    }
    return texture;
}

TEST(MipChain, HalvesDownToOneTexel) {
    const auto chain = cutout_mip_chain(leaves(64, 16), 0.5F);
    ASSERT_EQ(chain.size(), 6U);
    EXPECT_EQ(chain[0].width, 32);
    EXPECT_EQ(chain[0].height, 8);
    EXPECT_EQ(chain[4].width, 2);
    EXPECT_EQ(chain[4].height, 1);
    EXPECT_EQ(chain[5].width, 1);
    for (const MipLevel& level : chain) {
        EXPECT_EQ(level.rgba.size(), 4U * static_cast<unsigned>(level.width * level.height));
    }
}

TEST(MipChain, PreservesAlphaCoverage) {
    const scene::Texture texture = leaves(96, 96);
    const double expected = alpha_coverage(texture.rgba, 1.0, 0.5);
    EXPECT_NEAR(expected, 1.0 / 3.0, 0.02);
    const auto chain = cutout_mip_chain(texture, 0.5F);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(alpha_coverage(chain[i].rgba, 1.0, 0.5), expected, 0.12) << "level " << i + 1;
    }
}

TEST(MipChain, ColorOfHolesDoesNotBleedIntoLeaves) {
    for (const MipLevel& level : cutout_mip_chain(leaves(64, 64), 0.5F)) {
        for (std::size_t i = 0; i < level.rgba.size(); i += 4) {
            if (level.rgba[i + 3] > 127) {
                EXPECT_GT(level.rgba[i + 1], level.rgba[i]) << "still green";
            }
        }
    }
}

TEST(MipChain, OneTexelHasNoFurtherLevels) {
    EXPECT_TRUE(cutout_mip_chain(leaves(1, 1), 0.5F).empty());
}

}  // namespace
}  // namespace campuswalk::engine::render
