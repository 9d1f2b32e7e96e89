#include "engine/render/image/read_png.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include <spng.h>

#include "scene/base/diagnostic.h"

namespace campuswalk::engine::render {
namespace {

// A small file can claim any size; 8K is 33 million pixels.
constexpr std::uint32_t kMaxSide = 32768;
constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 27U;
constexpr std::size_t kMaxChunk = std::size_t{1} << 24U;  ///< bytes, of texts and profiles

constexpr std::array<unsigned char, 8> kPngSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

class PngReader {
public:
    explicit PngReader(const std::filesystem::path& file)
        : name_(file), decoder_(spng_ctx_new(0), spng_ctx_free) {
        if (std::error_code ignored; std::filesystem::is_other(file, ignored)) {
            refuse("unreadable-file", "it is a pipe, a socket or a device; name a picture's file");
        }
        stream_.reset(std::fopen(file.c_str(), "rb"));
        if (!stream_) {
            const int reason = errno;
            refuse(reason == ENOENT || reason == ENOTDIR ? scene::DiagnosticCode("missing-file")
                                                         : "unreadable-file",
                   std::string("can't read the picture: ") + std::strerror(reason));
        }
        check_signature();
    }

    Image read() {
        check(decoder_ ? 0 : SPNG_EMEM);
        check(spng_set_png_file(decoder_.get(), stream_.get()));
        check(spng_set_image_limits(decoder_.get(), kMaxSide, kMaxSide));
        check(spng_set_chunk_limits(decoder_.get(), kMaxChunk, kMaxChunk));
        spng_ihdr header{};
        check(spng_get_ihdr(decoder_.get(), &header));
        if (std::uint64_t{header.width} * header.height > kMaxPixels) {
            refuse("bad-picture", "the picture has " + std::to_string(header.width) + "x" +
                                      std::to_string(header.height) + " pixels, which is too large");
        }
        Image image;
        image.width = static_cast<int>(header.width);
        image.height = static_cast<int>(header.height);
        image.rgba.resize(std::size_t{4} * header.width * header.height);
        check(spng_decode_image(decoder_.get(), image.rgba.data(), image.rgba.size(), SPNG_FMT_RGBA8,
                                SPNG_DECODE_TRNS));
        // Verifies the checksums of the chunks after the pixels.
        check(spng_decode_chunks(decoder_.get()));
        return image;
    }

private:
    /// libspng would report a short text file as truncated.
    void check_signature() const {
        std::array<unsigned char, kPngSignature.size()> read{};
        const std::size_t count = std::fread(read.data(), 1, read.size(), stream_.get());
        if (std::ferror(stream_.get()) != 0) {
            refuse("unreadable-file", std::string("can't read the picture: ") + std::strerror(errno));
        }
        if (count < read.size() || read != kPngSignature) {
            refuse("bad-picture", "this is not a PNG file");
        }
        std::rewind(stream_.get());
    }

    void check(int error) const {
        if (error == 0) {
            return;
        }
        if (error == SPNG_EWIDTH || error == SPNG_EHEIGHT || error == SPNG_EUSER_WIDTH ||
            error == SPNG_EUSER_HEIGHT) {
            refuse("bad-picture",
                   "each side of the picture must be 1 to " + std::to_string(kMaxSide) + " pixels long");
        }
        refuse("bad-picture", std::string("the PNG file is truncated or corrupt: ") + spng_strerror(error));
    }

    [[noreturn]] void refuse(scene::DiagnosticCode code, const std::string& message) const {
        throw scene::InputError(scene::SourceMark{name_.string(), 0, 0}, code, message);
    }

    std::filesystem::path name_;
    std::unique_ptr<std::FILE, CloseFile> stream_;
    std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> decoder_;
};

/// Blends over white, in sRGB like browsers.
void blend_over_white(Image& image) {
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        const int alpha = image.rgba[i + 3];
        if (alpha == 255) {
            continue;
        }
        for (std::size_t c = i; c < i + 3; ++c) {
            image.rgba[c] =
                static_cast<std::uint8_t>((image.rgba[c] * alpha + 255 * (255 - alpha) + 127) / 255);
        }
        image.rgba[i + 3] = 255;
    }
}

}  // namespace

Image read_png(const std::filesystem::path& file) {
    Image image = PngReader(file).read();
    blend_over_white(image);
    return image;
}

}  // namespace campuswalk::engine::render
