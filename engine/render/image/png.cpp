#include "engine/render/image/png.h"

#include <cstdlib>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

#include <spng.h>

#include "engine/render/image/png_file.h"
#include "scene/base/atomic_file.h"

namespace campuswalk::engine::render {
namespace {

// Depth is smooth: the Paeth filter halves the file.
constexpr int kDepthCompressionLevel = 3;

void check(int error) {
    if (error != 0) {
        throw std::runtime_error(std::string("PNG encoder: ") + spng_strerror(error));
    }
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, std::string_view software) {
    PixelCompressor compressor;
    PngWriter file(image.width, image.height);
    if (!software.empty()) {
        const std::string text = std::string("Software") + '\0' + std::string(software);
        file.chunk("tEXt", {std::vector<std::uint8_t>(text.begin(), text.end())});
    }
    file.chunk("IDAT", {compressor.compress(image)});
    file.end();
    return file.take();
}

std::vector<std::uint8_t> encode_depth_png(int width, int height, const std::vector<std::uint16_t>& values) {
    const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> encoder(spng_ctx_new(SPNG_CTX_ENCODER),
                                                                 spng_ctx_free);
    check(encoder ? 0 : SPNG_EMEM);
    check(spng_set_option(encoder.get(), SPNG_ENCODE_TO_BUFFER, 1));
    check(spng_set_option(encoder.get(), SPNG_IMG_COMPRESSION_LEVEL, kDepthCompressionLevel));
    check(spng_set_option(encoder.get(), SPNG_FILTER_CHOICE, SPNG_FILTER_CHOICE_PAETH));
    spng_ihdr header{};
    header.width = static_cast<std::uint32_t>(width);
    header.height = static_cast<std::uint32_t>(height);
    header.bit_depth = 16;
    header.color_type = SPNG_COLOR_TYPE_GRAYSCALE;
    check(spng_set_ihdr(encoder.get(), &header));
    // The encoder converts from the native byte order.
    check(spng_encode_image(encoder.get(), values.data(), 2 * values.size(), SPNG_FMT_PNG,
                            SPNG_ENCODE_FINALIZE));
    std::size_t size = 0;
    int error = 0;
    const std::unique_ptr<void, void (*)(void*)> bytes(spng_get_png_buffer(encoder.get(), &size, &error),
                                                       std::free);
    check(error);
    const auto* first = static_cast<const std::uint8_t*>(bytes.get());
    return {first, first + size};
}

void write_png(const Image& image, const std::filesystem::path& file, std::string_view software) {
    const std::vector<std::uint8_t> bytes = encode_png(image, software);
    scene::write_file_atomically(file, std::as_bytes(std::span(bytes)));
}

}  // namespace campuswalk::engine::render
