#include "engine/render/sequence/animated_gif.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gif_lib.h>

#include "engine/render/sequence/animated_png.h"
#include "engine/render/sequence/scaled_image.h"

namespace campuswalk::engine::render {
namespace {

// Levels of red, green and blue: the eye is most sensitive to green.
constexpr std::array<int, 3> kLevels = {6, 7, 6};
constexpr int kColors = 256;  // GIF palettes have a power of two

/// 8 x 8 Bayer matrix for ordered dithering.
int bayer(int x, int y) {
    int value = 0;
    for (int bit = 0; bit < 3; ++bit) {
        const int column = (x >> bit) & 1;
        const int row = (y >> bit) & 1;
        value |= ((column ^ row) << (5 - 2 * bit)) | (row << (4 - 2 * bit));
    }
    return value;
}

/// Quantizes a value with a dither threshold of 0 to 63.
int level(int value, int levels, int threshold) {
    return (value * (levels - 1) * 64 + threshold * 255 + 127) / (255 * 64);
}

std::array<GifColorType, kColors> palette() {
    std::array<GifColorType, kColors> colors{};
    std::size_t next = 0;
    for (int r = 0; r < kLevels[0]; ++r) {
        for (int g = 0; g < kLevels[1]; ++g) {
            for (int b = 0; b < kLevels[2]; ++b) {
                const auto byte = [](int at, int levels) {
                    return static_cast<GifByteType>(at * 255 / (levels - 1));
                };
                colors[next++] = {byte(r, kLevels[0]), byte(g, kLevels[1]), byte(b, kLevels[2])};
            }
        }
    }
    return colors;
}

void dither_row(const Image& image, int y, std::vector<GifPixelType>& row) {
    const std::uint8_t* pixel = &image.rgba[image.offset(0, y)];
    for (int x = 0; x < image.width; ++x, pixel += 4) {
        const int threshold = bayer(x, y);
        const int red = level(pixel[0], kLevels[0], threshold);
        const int green = level(pixel[1], kLevels[1], threshold);
        const int blue = level(pixel[2], kLevels[2], threshold);
        row[static_cast<std::size_t>(x)] =
            static_cast<GifPixelType>((red * kLevels[1] + green) * kLevels[2] + blue);
    }
}

}  // namespace

AnimatedGif::AnimatedGif(std::filesystem::path file, double seconds_per_frame)
    : file_(std::move(file)),
      hundredths_(static_cast<int>(std::clamp(std::round(100.0 * seconds_per_frame), 2.0, 65535.0))) {}

void AnimatedGif::Close::operator()(GifFileType* gif) const {
    int error = 0;
    EGifCloseFile(gif, &error);
}

int AnimatedGif::write(GifFileType* gif, const unsigned char* data, int size) {
    Output& output = *static_cast<Output*>(gif->UserData);
    try {
        output.file.write(std::as_bytes(std::span(data, static_cast<std::size_t>(size))));
        return size;
    } catch (...) {
        output.failure = std::current_exception();
        return 0;
    }
}

void AnimatedGif::check(int status) const {
    if (output_->failure) {
        std::rethrow_exception(output_->failure);
    }
    if (status != GIF_OK) {
        throw std::runtime_error("can't make the GIF: out of memory");
    }
}

void AnimatedGif::begin(const Image& image) {
    output_ = std::unique_ptr<Output>(new Output{scene::AtomicFile(file_), nullptr});
    int error = 0;
    gif_.reset(EGifOpen(output_.get(), write, &error));
    check(gif_ ? GIF_OK : GIF_ERROR);
    EGifSetGifVersion(gif_.get(), true);
    const std::array<GifColorType, kColors> colors = palette();
    const std::unique_ptr<ColorMapObject, void (*)(ColorMapObject*)> map(
        GifMakeMapObject(kColors, colors.data()), GifFreeMapObject);
    check(EGifPutScreenDesc(gif_.get(), image.width, image.height, 8, 0, map.get()));
    const std::array<GifByteType, 3> loop_forever = {1, 0, 0};
    check(EGifPutExtensionLeader(gif_.get(), APPLICATION_EXT_FUNC_CODE));
    check(EGifPutExtensionBlock(gif_.get(), 11, "NETSCAPE2.0"));
    check(EGifPutExtensionBlock(gif_.get(), static_cast<int>(loop_forever.size()), loop_forever.data()));
    check(EGifPutExtensionTrailer(gif_.get()));
}

void AnimatedGif::add(const Frame& frame) {
    const Image image = scaled_down(frame.image, kAnimationWidth);
    if (!gif_) {
        begin(image);
    }
    const std::array<GifByteType, 4> control = {0, static_cast<GifByteType>(hundredths_ & 0xFF),
                                                static_cast<GifByteType>(hundredths_ >> 8), 0};
    check(EGifPutExtension(gif_.get(), GRAPHICS_EXT_FUNC_CODE, static_cast<int>(control.size()),
                           control.data()));
    check(EGifPutImageDesc(gif_.get(), 0, 0, image.width, image.height, false, nullptr));
    std::vector<GifPixelType> row(static_cast<std::size_t>(image.width));
    for (int y = 0; y < image.height; ++y) {
        dither_row(image, y, row);
        check(EGifPutLine(gif_.get(), row.data(), image.width));
    }
}

void AnimatedGif::finish() {
    if (gif_) {
        gif_.reset();
        check(GIF_OK);
        output_->file.finish();
    }
}

}  // namespace campuswalk::engine::render
