#include "engine/render/snapshot/channel_files.h"

#include <fstream>
#include <iterator>
#include <set>

#include <gtest/gtest.h>
#include <spng.h>
#include <nlohmann/json.hpp>

#include "engine/render/image/png.h"
#include "tests/engine/render/scratch_folder.h"
#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

std::vector<std::uint8_t> bytes(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

template <typename Value>
std::vector<Value> decoded(const std::vector<std::uint8_t>& png, int format) {
    const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> decoder(spng_ctx_new(0), spng_ctx_free);
    spng_set_png_buffer(decoder.get(), png.data(), png.size());
    std::size_t size = 0;
    EXPECT_EQ(spng_decoded_image_size(decoder.get(), format, &size), 0);
    std::vector<Value> values(size / sizeof(Value));
    EXPECT_EQ(spng_decode_image(decoder.get(), values.data(), size, format, 0), 0);
    return values;
}

TEST(ChannelFiles, MillimetresAreRoundedAndClamped) {
    EXPECT_EQ(millimetres({0.0F, 0.0001F, 1.2344F, 1.2346F, 65.535F, 65.6F, 1e9F}),
              (std::vector<std::uint16_t>{0, 1, 1234, 1235, 65535, 65535, 65535}));
}

TEST(ChannelFiles, EveryIdHasAUniqueColor) {
    EXPECT_EQ(id_color(0), (std::array<std::uint8_t, 3>{0, 0, 0}));
    std::set<std::array<std::uint8_t, 3>> colors;
    for (std::uint32_t id = 0; id < 100'000; ++id) {
        colors.insert(id_color(id));
    }
    EXPECT_EQ(colors.size(), 100'000U);
}

TEST(ChannelFiles, DepthRoundTripsAllSixteenBits) {
    std::vector<std::uint16_t> values;
    values.reserve(300);
    for (int i = 0; i < 300; ++i) {
        values.push_back(static_cast<std::uint16_t>(i * 217));
    }
    EXPECT_EQ(decoded<std::uint16_t>(encode_depth_png(20, 15, values), SPNG_FMT_PNG), values);
}

TEST(ChannelFiles, DescribeTheImage) {
    scene::Building tower;
    tower.id = "tower";
    const scene::Campus campus = campus_of(tower_scene(), {tower});
    SnapshotSettings settings;
    settings.light = quick_settings();
    SnapshotRenderer snapshot_renderer(campus, settings);
    SnapshotRequest request;
    request.camera.width = kWidth;
    request.camera.height = kHeight;
    request.avatar.position = {1, 0, 2};
    const ImageChannels requested{.depth = true, .ids = true, .normals = true};
    const Channels channels = snapshot_renderer.draw_channels(request, choice_of(requested));
    const ScratchFolder folder;
    const auto files = write_channels(snapshot_renderer, campus, channels, requested, folder.path() / "view");
    ASSERT_EQ(files.size(), 4U);
    EXPECT_EQ(files[0].filename(), "view-depth.png");
    EXPECT_EQ(decoded<std::uint16_t>(bytes(files[0]), SPNG_FMT_PNG), millimetres(channels.depth));

    const std::vector<std::uint8_t> json = bytes(files[2]);
    const auto names = nlohmann::json::parse(json.begin(), json.end());
    EXPECT_EQ(names["width"], kWidth);
    const auto& entry = names["ids"].at(1);
    EXPECT_EQ(entry["building"], "tower");
    EXPECT_FALSE(entry.contains("object"));
    const std::vector<std::uint8_t> colors = decoded<std::uint8_t>(bytes(files[1]), SPNG_FMT_RGB8);
    const auto [r, g, b] = id_color(entry["id"]);
    std::size_t count = 0;
    for (std::size_t i = 0; i < colors.size(); i += 3) {
        count += colors[i] == r && colors[i + 1] == g && colors[i + 2] == b ? 1U : 0U;
    }
    EXPECT_EQ(entry["pixels"], count);
    EXPECT_GT(count, 100U);
    EXPECT_EQ(decoded<std::uint8_t>(bytes(files[3]), SPNG_FMT_RGBA8), channels.normals.rgba);
}

}  // namespace
}  // namespace campuswalk::engine::render::test
