#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "engine/render/picture.h"

struct libdeflate_compressor;

namespace campuswalk::engine::render {

/// Puts a PNG file of 8-bit RGB together in memory, chunk by chunk: a picture or, with the chunks of
/// animations, several of one size. (libspng writes neither those nor as fast as libdeflate compresses.)
class PngFile {
public:
    /// Writes the signature and the header.
    PngFile(int width, int height);

    /// `kind` has four letters. The data are the parts, one after the other.
    void chunk(std::string_view kind, std::initializer_list<std::span<const std::uint8_t>> parts);
    void end() { chunk("IEND", {}); }

    std::size_t size() const { return bytes_.size(); }
    /// Replaces the data of a chunk that begins at this offset, the same number of bytes.
    void replace(std::size_t offset, std::span<const std::uint8_t> data);
    std::vector<std::uint8_t> take() { return std::move(bytes_); }

private:
    void put_checksum(std::size_t kind_at, std::size_t checksum_at);

    std::vector<std::uint8_t> bytes_;
};

/// Four bytes as PNG has its numbers, the highest first.
std::array<std::uint8_t, 4> png_number(std::uint32_t value);

/// Compresses pictures as PNG files have them. Keeps its memory from one to the next.
class PixelCompressor {
public:
    PixelCompressor();

    /// Valid until the next call.
    std::span<const std::uint8_t> compress(const Picture& picture);

private:
    struct Free {
        void operator()(libdeflate_compressor* compressor) const;
    };
    std::unique_ptr<libdeflate_compressor, Free> compressor_;
    std::vector<std::uint8_t> rows_;
    std::vector<std::uint8_t> compressed_;
};

}  // namespace campuswalk::engine::render
