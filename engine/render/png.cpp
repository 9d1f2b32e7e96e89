#include "engine/render/png.h"

#include <cstdlib>
#include <cstring>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

#include <spng.h>

#include "scene/whole_file.h"

namespace campuswalk::engine::render {
namespace {

// Level 1 with one filter for all rows: 8 times faster than libpng's defaults, files a fifth larger.
constexpr int kCompressionLevel = 1;

std::vector<std::uint8_t> without_alpha(const Picture& picture) {
    const std::size_t pixels = picture.rgba.size() / 4;
    std::vector<std::uint8_t> rgb(3 * pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        std::memcpy(&rgb[3 * i], &picture.rgba[4 * i], 3);
    }
    return rgb;
}

void check(int error, const char* doing) {
    if (error != 0) {
        throw std::runtime_error(std::string("PNG encoder, ") + doing + ": " + spng_strerror(error));
    }
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Picture& picture) {
    const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> encoder(spng_ctx_new(SPNG_CTX_ENCODER),
                                                                 spng_ctx_free);
    check(encoder ? 0 : SPNG_EMEM, "start");
    check(spng_set_option(encoder.get(), SPNG_ENCODE_TO_BUFFER, 1), "option");
    check(spng_set_option(encoder.get(), SPNG_IMG_COMPRESSION_LEVEL, kCompressionLevel), "option");
    check(spng_set_option(encoder.get(), SPNG_FILTER_CHOICE, SPNG_FILTER_CHOICE_SUB), "option");

    spng_ihdr header{};
    header.width = static_cast<std::uint32_t>(picture.width);
    header.height = static_cast<std::uint32_t>(picture.height);
    header.bit_depth = 8;
    header.color_type = SPNG_COLOR_TYPE_TRUECOLOR;
    check(spng_set_ihdr(encoder.get(), &header), "header");

    const std::vector<std::uint8_t> rgb = without_alpha(picture);
    check(spng_encode_image(encoder.get(), rgb.data(), rgb.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE),
          "rows");

    std::size_t size = 0;
    int error = 0;
    const std::unique_ptr<void, void (*)(void*)> bytes(spng_get_png_buffer(encoder.get(), &size, &error),
                                                       std::free);
    check(error, "finish");
    const auto* first = static_cast<const std::uint8_t*>(bytes.get());
    return {first, first + size};
}

void write_png(const Picture& picture, const std::filesystem::path& file) {
    const std::vector<std::uint8_t> bytes = encode_png(picture);
    scene::write_whole_file(file, std::as_bytes(std::span(bytes)));
}

}  // namespace campuswalk::engine::render
