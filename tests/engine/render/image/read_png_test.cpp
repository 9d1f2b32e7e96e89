#include "engine/render/image/read_png.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <random>
#include <string>

#include <spng.h>

#include <gtest/gtest.h>

#include "engine/render/image/png.h"
#include "scene/base/diagnostic.h"
#include "tests/engine/render/color_names.h"
#include "tests/engine/render/compare/synthetic_images.h"
#include "tests/engine/render/scratch_folder.h"

namespace campuswalk::engine::render::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

void write(const std::filesystem::path& file, const Bytes& bytes) {
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// Writes a file of 2x1 pixels in any format; `pixels` as encoded.
void write_kind(const std::filesystem::path& file, spng_color_type type, std::uint8_t depth,
                const Bytes& pixels, const std::vector<spng_plte_entry>& palette = {}) {
    const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> encoder(spng_ctx_new(SPNG_CTX_ENCODER),
                                                                 spng_ctx_free);
    spng_set_option(encoder.get(), SPNG_ENCODE_TO_BUFFER, 1);
    spng_ihdr header{2, 1, depth, static_cast<std::uint8_t>(type), 0, 0, 0};
    spng_set_ihdr(encoder.get(), &header);
    if (!palette.empty()) {
        spng_plte table{};
        table.n_entries = static_cast<std::uint32_t>(palette.size());
        std::copy(palette.begin(), palette.end(), table.entries);
        spng_set_plte(encoder.get(), &table);
    }
    ASSERT_EQ(
        spng_encode_image(encoder.get(), pixels.data(), pixels.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE),
        0);
    std::size_t size = 0;
    int error = 0;
    const std::unique_ptr<void, void (*)(void*)> made(spng_get_png_buffer(encoder.get(), &size, &error),
                                                      std::free);
    const auto* first = static_cast<const std::uint8_t*>(made.get());
    write(file, {first, first + size});
}

std::string error_of(const std::filesystem::path& file) {
    try {
        read_png(file);
    } catch (const scene::InputError& error) {
        const scene::Diagnostic& first = error.diagnostics().front();
        EXPECT_EQ(first.mark.file, file.string());
        return std::string(first.code.text()) + ": " + first.message;
    }
    return {};
}

TEST(ReadPng, ReadsWrittenImages) {
    const ScratchFolder folder;
    std::mt19937 random(1);
    for (const auto& [width, height] : {std::pair(97, 61), std::pair(1, 1), std::pair(1280, 3)}) {
        const Image image = noise(width, height, random);
        write_png(image, folder.path() / "a.png");
        const Image read = read_png(folder.path() / "a.png");
        EXPECT_EQ(read.width, width);
        EXPECT_EQ(read.height, height);
        EXPECT_EQ(read.rgba, image.rgba);
    }
}

TEST(ReadPng, ConvertsOtherColorTypes) {
    const ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "a.png";
    using Rgb = std::array<std::uint8_t, 3>;
    write_kind(file, SPNG_COLOR_TYPE_GRAYSCALE, 8, {7, 200});
    EXPECT_EQ(read_png(file).pixel(1, 0), (Rgb{200, 200, 200}));
    write_kind(file, SPNG_COLOR_TYPE_GRAYSCALE, 16, {0x00, 0x00, 0x00, 0xFF});  // in native byte order
    EXPECT_EQ(read_png(file).pixel(0, 0), (Rgb{0, 0, 0}));
    EXPECT_EQ(read_png(file).pixel(1, 0), (Rgb{255, 255, 255}));
    write_kind(file, SPNG_COLOR_TYPE_INDEXED, 8, {1, 0}, {{10, 20, 30, 255}, {40, 50, 60, 255}});
    EXPECT_EQ(read_png(file).pixel(0, 0), (Rgb{40, 50, 60}));
    EXPECT_EQ(read_png(file).pixel(1, 0), (Rgb{10, 20, 30}));
}

TEST(ReadPng, BlendsTransparencyOverWhite) {
    const ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "a.png";
    write_kind(file, SPNG_COLOR_TYPE_TRUECOLOR_ALPHA, 8, {200, 0, 0, 0, 0, 100, 255, 51});
    const Image image = read_png(file);
    EXPECT_EQ(image.pixel(0, 0), (std::array<std::uint8_t, 3>{255, 255, 255}));
    EXPECT_EQ(image.pixel(1, 0), (std::array<std::uint8_t, 3>{204, 224, 255})) << "a fifth of it";
    EXPECT_EQ(image.rgba[3], 255);
}

TEST(ReadPng, ReportsInvalidFiles) {
    const ScratchFolder folder;
    const std::string missing = error_of(folder.path() / "none.png");
    EXPECT_TRUE(missing.starts_with("missing-file: ") && missing.ends_with(std::strerror(ENOENT))) << missing;
    const std::string unreadable = error_of(folder.path());
    EXPECT_TRUE(unreadable.starts_with("unreadable-file: ") && unreadable.ends_with(std::strerror(EISDIR)))
        << unreadable;
    write(folder.path() / "text.png", {'h', 'e', 'l', 'l', 'o', ' ', 't', 'h', 'e', 'r', 'e'});
    EXPECT_TRUE(error_of(folder.path() / "text.png").starts_with("bad-picture: "));
    write(folder.path() / "empty.png", {});
    EXPECT_TRUE(error_of(folder.path() / "empty.png").starts_with("bad-picture: "));
}

TEST(ReadPng, RejectsTruncatedFiles) {
    const ScratchFolder folder;
    std::mt19937 random(3);
    const Bytes whole = encode_png(noise(20, 20, random));
    for (std::size_t size = 0; size < whole.size() - 12; size += 7) {  // without the empty last chunk
        const std::filesystem::path file = folder.path() / "cut.png";
        write(file, {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)});
        EXPECT_EQ(error_of(file).substr(0, 11), "bad-picture") << size;
    }
}

TEST(ReadPng, SurvivesFlippedBits) {
    const ScratchFolder folder;
    std::mt19937 random(4);
    const Bytes whole = encode_png(noise(20, 20, random));
    int rejected = 0;
    for (int i = 0; i < 300; ++i) {
        Bytes bytes = whole;
        bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1U << (random() % 8U));
        write(folder.path() / "flipped.png", bytes);
        rejected += error_of(folder.path() / "flipped.png").empty() ? 0 : 1;
    }
    EXPECT_GT(rejected, 270);
}

// A header with a valid checksum and no pixels.
TEST(ReadPng, RejectsHugeSizes) {
    const ScratchFolder folder;
    const Bytes signature = {0x89, 'P', 'N', 'G', 0x0D, 0x0A, 0x1A, 0x0A, 0, 0, 0, 13, 'I', 'H', 'D', 'R'};
    const std::vector<std::pair<Bytes, std::string>> claims = {
        {{0, 0, 0x70, 0, 0, 0, 0x70, 0, 8, 6, 0, 0, 0, 0x29, 0xC1, 0xFE, 0xCA}, "28672x28672"},
        {{0x7F, 0xFF, 0xFF, 0xFF, 0, 0, 0, 1, 8, 6, 0, 0, 0, 0xA0, 0x36, 0x33, 0xDD}, "32768 pixels"}};
    for (const auto& [header, expected] : claims) {
        Bytes bytes = signature;
        bytes.insert(bytes.end(), header.begin(), header.end());
        bytes.insert(bytes.end(), {0, 0, 0, 1, 'I', 'D', 'A', 'T', 0, 0x28, 0x38, 0x7D, 0xE8});
        write(folder.path() / "huge.png", bytes);
        EXPECT_NE(error_of(folder.path() / "huge.png").find(expected), std::string::npos)
            << error_of(folder.path() / "huge.png");
    }
}

}  // namespace
}  // namespace campuswalk::engine::render::test
