#include "engine/render/image/png.h"

#include <cstring>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>

#include <cairo.h>
#include <gtest/gtest.h>
#include "tests/engine/render/color_names.h"
#include "tests/engine/render/scratch_folder.h"
#include "tests/support/full_disk.h"

namespace campuswalk::engine::render::test {
namespace {

// Rows, columns and channels all differ.
Image pattern(int width, int height) {
    Image image = plain_image(width, height, {0, 0, 0});
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::uint8_t* pixel = &image.rgba[image.offset(x, y)];
            pixel[0] = static_cast<std::uint8_t>(7 * x + y);
            pixel[1] = static_cast<std::uint8_t>(x * y);
            pixel[2] = static_cast<std::uint8_t>(200 - 3 * y);
        }
    }
    return image;
}

// Decodes with libpng through cairo, not with the library that encodes.
Image decoded(const std::filesystem::path& file) {
    const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface(
        cairo_image_surface_create_from_png(file.c_str()), cairo_surface_destroy);
    if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) {
        return {};
    }
    Image image = plain_image(cairo_image_surface_get_width(surface.get()),
                              cairo_image_surface_get_height(surface.get()), {0, 0, 0});
    for (int y = 0; y < image.height; ++y) {
        const unsigned char* row = cairo_image_surface_get_data(surface.get()) +
                                   std::ptrdiff_t{y} * cairo_image_surface_get_stride(surface.get());
        for (int x = 0; x < image.width; ++x) {
            std::uint32_t value = 0;
            std::memcpy(&value, row + std::ptrdiff_t{4} * x, 4);
            std::uint8_t* pixel = &image.rgba[image.offset(x, y)];
            pixel[0] = static_cast<std::uint8_t>(value >> 16U);
            pixel[1] = static_cast<std::uint8_t>(value >> 8U);
            pixel[2] = static_cast<std::uint8_t>(value);
        }
    }
    return image;
}

std::string error_of_writing(const Image& image, const std::filesystem::path& file) {
    try {
        write_png(image, file);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

TEST(Png, AnotherDecoderReadsTheSamePixels) {
    const ScratchFolder folder;
    for (const auto& [width, height] : {std::pair(97, 61), std::pair(1, 1), std::pair(1280, 3)}) {
        const Image image = pattern(width, height);
        write_png(image, folder.path() / "picture.png");
        const Image read = decoded(folder.path() / "picture.png");
        ASSERT_EQ(read.width, width);
        ASSERT_EQ(read.height, height);
        EXPECT_EQ(read.rgba, image.rgba);
    }
}

TEST(Png, IsDeterministic) {
    EXPECT_EQ(encode_png(pattern(50, 40)), encode_png(pattern(50, 40)));
    EXPECT_NE(encode_png(pattern(50, 40)), encode_png(pattern(40, 50)));
}

TEST(Png, CreatesMissingFoldersAndReplacesAnOldImage) {
    const ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "deep" / "er" / "picture.png";
    write_png(pattern(8, 8), file);
    write_png(pattern(9, 9), file);
    EXPECT_EQ(decoded(file).width, 9);
    EXPECT_EQ(folder.contents().size(), 3U) << "two folders, one file and no temporary file";
}

// Not a folder without permissions: root could write into that.
TEST(Png, AFileInPlaceOfAFolderIsReported) {
    const ScratchFolder folder;
    std::ofstream(folder.path() / "out") << "not a folder";
    const std::filesystem::path file = folder.path() / "out" / "walk" / "picture.png";
    const std::string error = error_of_writing(pattern(8, 8), file);
    EXPECT_NE(error.find(file.string()), std::string::npos) << error;
    EXPECT_NE(error.find(std::strerror(ENOTDIR)), std::string::npos) << error;
    EXPECT_EQ(folder.contents().size(), 1U);
}

TEST(Png, AFolderInPlaceOfAFileLeavesNothingBehind) {
    const ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "picture.png";
    std::filesystem::create_directories(file / "occupied");
    EXPECT_NE(error_of_writing(pattern(8, 8), file), "");
    EXPECT_EQ(folder.contents(), (std::vector<std::filesystem::path>{"picture.png", "picture.png/occupied"}));
}

TEST(Png, AFullDiskLeavesNoPartialImageAndKeepsTheOldOne) {
    const ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "picture.png";
    write_png(pattern(8, 8), file);
    std::string error;
    {
        const campuswalk::test::FullDisk disk(1000);
        error = error_of_writing(pattern(300, 300), file);
    }
    EXPECT_NE(error.find(std::strerror(EFBIG)), std::string::npos) << error;
    EXPECT_EQ(decoded(file).rgba, pattern(8, 8).rgba);
    EXPECT_EQ(folder.contents(), std::vector<std::filesystem::path>{"picture.png"});
}

}  // namespace
}  // namespace campuswalk::engine::render::test
