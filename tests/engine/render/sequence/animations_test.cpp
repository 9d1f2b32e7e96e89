// Decodes animations with libraries other than those that encode them.

#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <string>

#include <gif_lib.h>
#include <gtest/gtest.h>

#include "engine/render/image/read_png.h"
#include "engine/render/sequence/animated_gif.h"
#include "engine/render/sequence/animated_png.h"
#include "engine/render/sequence/contact_sheet.h"
#include "engine/render/sequence/frame_files.h"
#include "tests/engine/render/color_names.h"
#include "tests/engine/render/compare/synthetic_images.h"
#include "tests/engine/render/scratch_folder.h"
#include "tests/support/full_disk.h"

namespace campuswalk::engine::render::test {
namespace {

std::vector<Image> three_images(int width, int height) {
    std::mt19937 random(5);
    return {noise(width, height, random), plain_image(width, height, {10, 200, 90}),
            noise(width, height, random)};
}

void feed(FrameSink& sink, const std::vector<Image>& images) {
    for (std::size_t i = 0; i < images.size(); ++i) {
        sink.add({images[i], i, 0.5 * static_cast<double>(i)});
    }
    sink.finish();
}

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::uint32_t number(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = at; i < at + 4; ++i) {
        value = (value << 8U) | static_cast<std::uint8_t>(bytes[i]);
    }
    return value;
}

struct Chunk {
    std::string kind;
    std::string data;
    std::string whole;
};

std::vector<Chunk> chunks_of(const std::string& bytes) {
    std::vector<Chunk> chunks;
    for (std::size_t at = 8; at < bytes.size();) {
        const std::size_t size = number(bytes, at);
        chunks.push_back({bytes.substr(at + 4, 4), bytes.substr(at + 8, size), bytes.substr(at, size + 12)});
        at += size + 12;
    }
    return chunks;
}

TEST(AnimatedPng, PlainDecodersReadItsFirstFrame) {
    const ScratchFolder folder;
    const std::vector<Image> images = three_images(40, 30);
    AnimatedPng animation(folder.path() / "a.png", 0.25);
    feed(animation, images);
    // libspng verifies the checksums of unknown chunks too.
    EXPECT_EQ(read_png(folder.path() / "a.png").rgba, images[0].rgba);
}

TEST(AnimatedPng, ContainsEveryFrame) {
    const ScratchFolder folder;
    const std::vector<Image> images = three_images(40, 30);
    AnimatedPng animation(folder.path() / "a.png", 0.25);
    feed(animation, images);
    const std::string bytes = bytes_of(folder.path() / "a.png");
    const std::vector<Chunk> chunks = chunks_of(bytes);
    std::string kinds;
    for (const Chunk& chunk : chunks) {
        kinds += chunk.kind + " ";
    }
    EXPECT_EQ(kinds, "IHDR acTL fcTL IDAT fcTL fdAT fcTL fdAT IEND ");
    EXPECT_EQ(number(chunks[1].data, 0), 3U);
    EXPECT_EQ(number(chunks[1].data, 4), 0U) << "loops";
    std::uint32_t sequence = 0;
    for (const Chunk& chunk : chunks) {
        if (chunk.kind == "fcTL") {
            EXPECT_EQ(number(chunk.data, 0), sequence++);
            EXPECT_EQ(number(chunk.data, 4), 40U);
            EXPECT_EQ(number(chunk.data, 8), 30U);
            EXPECT_EQ(number(chunk.data, 20), (250U << 16U) | 1000U) << "a quarter of a second";
        } else if (chunk.kind == "fdAT") {
            EXPECT_EQ(number(chunk.data, 0), sequence++);
        }
    }
}

TEST(AnimatedPng, IsDeterministicAndWritesNoFileWithoutFrames) {
    const ScratchFolder folder;
    const std::vector<Image> images = three_images(40, 30);
    for (const char* name : {"a.png", "b.png"}) {
        AnimatedPng animation(folder.path() / name, 0.25);
        feed(animation, images);
    }
    EXPECT_EQ(bytes_of(folder.path() / "a.png"), bytes_of(folder.path() / "b.png"));
    AnimatedPng none(folder.path() / "none.png", 0.25);
    feed(none, {});
    AnimatedGif no_gif(folder.path() / "none.gif", 0.25);
    feed(no_gif, {});
    EXPECT_EQ(folder.contents().size(), 2U);
}

std::unique_ptr<FrameSink> animation(const std::filesystem::path& file) {
    if (file.extension() == ".gif") {
        return std::make_unique<AnimatedGif>(file, 0.25);
    }
    return std::make_unique<AnimatedPng>(file, 0.25);
}

std::uintmax_t bytes_in(const ScratchFolder& folder) {
    std::uintmax_t sum = 0;
    for (const std::filesystem::path& file : folder.contents()) {
        sum += std::filesystem::file_size(folder.path() / file);
    }
    return sum;
}

TEST(Animations, AreWrittenIncrementallyAndAppearWhenComplete) {
    for (const char* name : {"a.png", "a.gif"}) {
        const ScratchFolder folder;
        std::mt19937 random(3);
        {
            const auto sink = animation(folder.path() / name);
            std::uintmax_t before = 0;
            for (std::size_t i = 0; i < 4; ++i) {
                sink->add({noise(200, 150, random), i, 0.0});
                EXPECT_GT(bytes_in(folder), before + 15000) << name << ", frame " << i;
                before = bytes_in(folder);
                EXPECT_FALSE(std::filesystem::exists(folder.path() / name));
            }
        }
        EXPECT_TRUE(folder.contents().empty()) << name << " was discarded";
    }
}

TEST(Animations, AFullDiskLeavesNoPartialFileAndKeepsTheOldOne) {
    for (const char* name : {"a.png", "a.gif"}) {
        const ScratchFolder folder;
        feed(*animation(folder.path() / name), three_images(8, 8));
        const std::string earlier = bytes_of(folder.path() / name);
        std::mt19937 random(3);
        const std::vector<Image> images(6, noise(200, 150, random));
        {
            const campuswalk::test::FullDisk full(100000);
            EXPECT_THROW(feed(*animation(folder.path() / name), images), std::runtime_error) << name;
        }
        EXPECT_EQ(folder.contents(), std::vector<std::filesystem::path>{name});
        EXPECT_EQ(bytes_of(folder.path() / name), earlier);
    }
}

TEST(AnimatedGif, ContainsEveryFrameInSimilarColours) {
    const ScratchFolder folder;
    const std::vector<Image> images = three_images(48, 32);
    {
        AnimatedGif animation(folder.path() / "a.gif", 0.5);
        feed(animation, images);
    }
    int error = 0;
    const auto close = [](GifFileType* gif) { DGifCloseFile(gif, nullptr); };
    const std::unique_ptr<GifFileType, decltype(close)> gif(
        DGifOpenFileName((folder.path() / "a.gif").c_str(), &error), close);
    ASSERT_TRUE(gif);
    ASSERT_EQ(DGifSlurp(gif.get()), GIF_OK);
    ASSERT_EQ(gif->ImageCount, 3);
    EXPECT_EQ(gif->SWidth, 48);
    for (int i = 0; i < 3; ++i) {
        GraphicsControlBlock control;
        ASSERT_EQ(DGifSavedExtensionToGCB(gif.get(), i, &control), GIF_OK);
        EXPECT_EQ(control.DelayTime, 50);
        const GifByteType* pixels = gif->SavedImages[i].RasterBits;
        std::array<double, 3> means = {0, 0, 0};
        std::array<double, 3> expected = {0, 0, 0};
        for (int y = 0; y < 32; ++y) {
            for (int x = 0; x < 48; ++x) {
                const GifColorType& color = gif->SColorMap->Colors[pixels[48 * y + x]];
                const auto exact = images[static_cast<std::size_t>(i)].pixel(x, y);
                const std::array<int, 3> got = {color.Red, color.Green, color.Blue};
                for (std::size_t c = 0; c < 3; ++c) {
                    // A step of 5 or 6 between the levels is 51 or 42.5.
                    EXPECT_LE(std::abs(got[c] - exact[c]), c == 1 ? 44 : 52);
                    means[c] += got[c] / 1536.0;
                    expected[c] += exact[c] / 1536.0;
                }
            }
        }
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(means[c], expected[c], 2.0) << "dithering keeps the mean";
        }
    }
}

TEST(ContactSheet, ArrangesFramesInRows) {
    const ScratchFolder folder;
    ContactSheet sheet(folder.path() / "sheet.png");
    std::vector<Image> images(7, plain_image(480, 270, {200, 0, 0}));
    images[6] = plain_image(480, 270, {0, 0, 200});
    feed(sheet, images);
    const Image drawn = read_png(folder.path() / "sheet.png");
    // Three columns of thumbnails 240 x 135 with gaps of 8.
    EXPECT_EQ(drawn.width, 3 * 248 + 8);
    EXPECT_EQ(drawn.height, 3 * 143 + 8);
    EXPECT_EQ(color_name(drawn, 20, 20), "red");
    EXPECT_EQ(color_name(drawn, 20, 2 * 143 + 20), "blue");
    EXPECT_EQ(color_name(drawn, 2 * 248 + 20, 2 * 143 + 20), "grey") << "an empty cell";
}

TEST(ContactSheet, SkipsFramesOfALongWalk) {
    const ScratchFolder folder;
    ContactSheet sheet(folder.path() / "sheet.png");
    feed(sheet, std::vector<Image>(500, plain_image(16, 9, {200, 0, 0})));
    const Image drawn = read_png(folder.path() / "sheet.png");
    EXPECT_LE(drawn.width, 10 * 24 + 8);
    EXPECT_LE(drawn.height, 13 * 17 + 8) << "120 frames at most, ten per row";
}

TEST(FrameFiles, ReplaceFilesOfAnEarlierWalk) {
    const ScratchFolder folder;
    {
        FrameFiles files(folder.path() / "frames");
        feed(files, std::vector<Image>(12, plain_image(8, 8, {1, 2, 3})));
    }
    std::ofstream(folder.path() / "frames" / "frame-mine.png") << "not one of ours";
    FrameFiles files(folder.path() / "frames");
    feed(files, three_images(8, 8));
    EXPECT_EQ(folder.contents(), (std::vector<std::filesystem::path>{
                                     "frames", "frames/frame-00001.png", "frames/frame-00002.png",
                                     "frames/frame-00003.png", "frames/frame-mine.png"}));
}

}  // namespace
}  // namespace campuswalk::engine::render::test
