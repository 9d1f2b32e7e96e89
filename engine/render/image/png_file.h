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

/// Puts a PNG file of 8-bit RGB together in memory, chunk by chunk: an image or, with the chunks of
/// animations, several of one size. (libspng writes neither those nor as fast as libdeflate compresses.)
class PngWriter {
public:
    /// Writes the signature and the header.
    PngWriter(int width, int height);

    /// `kind` has four letters. The data are the parts, one after the other.
    void chunk(std::string_view kind, std::initializer_list<std::span<const std::uint8_t>> parts);
    void end() { chunk("IEND", {}); }

    /// What has come since the last time.
    std::vector<std::uint8_t> take() { return std::exchange(bytes_, {}); }

private:
    std::vector<std::uint8_t> bytes_;
};

/// Four bytes as PNG has its numbers, the highest first.
std::array<std::uint8_t, 4> png_uint32(std::uint32_t value);

/// Compresses images as PNG files have them. Keeps its memory from one to the next.
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
