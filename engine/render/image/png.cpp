#include "engine/render/image/png.h"

#include <span>

#include "engine/render/image/png_file.h"
#include "scene/base/whole_file.h"

namespace campuswalk::engine::render {

std::vector<std::uint8_t> encode_png(const Picture& picture) {
    PixelCompressor compressor;
    PngFile file(picture.width, picture.height);
    file.chunk("IDAT", {compressor.compress(picture)});
    file.end();
    return file.take();
}

void write_png(const Picture& picture, const std::filesystem::path& file) {
    const std::vector<std::uint8_t> bytes = encode_png(picture);
    scene::write_whole_file(file, std::as_bytes(std::span(bytes)));
}

}  // namespace campuswalk::engine::render
