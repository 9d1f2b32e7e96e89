#include "engine/render/image/png.h"

#include <span>

#include "engine/render/image/png_file.h"
#include "scene/base/atomic_file.h"

namespace campuswalk::engine::render {

std::vector<std::uint8_t> encode_png(const Image& image) {
    PixelCompressor compressor;
    PngWriter file(image.width, image.height);
    file.chunk("IDAT", {compressor.compress(image)});
    file.end();
    return file.take();
}

void write_png(const Image& image, const std::filesystem::path& file) {
    const std::vector<std::uint8_t> bytes = encode_png(image);
    scene::write_file_atomically(file, std::as_bytes(std::span(bytes)));
}

}  // namespace campuswalk::engine::render
