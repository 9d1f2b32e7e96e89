#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/render/image/image.h"

struct libdeflate_compressor;

namespace campuswalk::engine::render {

/// Assembles an 8-bit RGB PNG file in memory, chunk by chunk: an image, or an animation of images of one
/// size. (libspng can't write animations, and libdeflate compresses faster.)
class PngWriter {
public:
    /// Writes the signature and the header.
    PngWriter(int width, int height);

    /// `kind` has four letters; `parts` are concatenated.
    void chunk(std::string_view kind, std::initializer_list<std::span<const std::uint8_t>> parts);
    void end() { chunk("IEND", {}); }

    /// The bytes since the last call.
    std::vector<std::uint8_t> take() { return std::exchange(bytes_, {}); }

private:
    std::vector<std::uint8_t> bytes_;
};

/// Big-endian bytes of an integer.
std::array<std::uint8_t, 4> png_uint32(std::uint32_t value);

/// Filters and compresses the pixels of PNG images. Reuses its memory.
class PixelCompressor {
public:
    PixelCompressor();

    /// Valid until the next call.
    std::span<const std::uint8_t> compress(const Image& image);

private:
    struct Free {
        void operator()(libdeflate_compressor* compressor) const;
    };
    std::unique_ptr<libdeflate_compressor, Free> compressor_;
    std::vector<std::uint8_t> rows_;
    std::vector<std::uint8_t> compressed_;
};

}  // namespace campuswalk::engine::render
