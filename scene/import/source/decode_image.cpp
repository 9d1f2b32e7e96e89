#include "scene/import/source/decode_image.h"

#include <limits>
#include <memory>
#include <string_view>

#include <turbojpeg.h>
#include <webp/decode.h>

// The only translation unit with stb_image's code; static, so that it can't clash with another copy.
#ifndef __clang_analyzer__  // not our code to fix
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#endif
#define STBI_NO_STDIO
#define STBI_NO_JPEG  // writes beyond a table that is too long
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_NO_PIC
#define STBI_NO_PNM
#define STBI_MAX_DIMENSIONS 16384
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
// False positive of g++ 12 at -O3 with assertions.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#if defined(__clang__)
// It copies no bytes of an empty chunk to a null pointer, which C2y allows.
#pragma clang attribute push(__attribute__((no_sanitize("nonnull-attribute"))), apply_to = function)
#endif
#include <stb/stb_image.h>
#if defined(__clang__)
#pragma clang attribute pop
#endif

namespace campuswalk::scene {
namespace {

constexpr int kMaxSide = STBI_MAX_DIMENSIONS;

/// Empty for an image that its file can plausibly contain: a hundred bytes may claim a gigabyte of pixels.
const char* why_too_large(int width, int height, std::size_t bytes) {
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
    // Else fuzzing spends its time on filling large, empty pictures: seven a second.
    constexpr std::size_t kAlwaysAllowed = std::size_t{64} * 64;
    constexpr std::size_t kPixelsPerByte = 100;
#else
    constexpr std::size_t kAlwaysAllowed = std::size_t{4096} * 4096;  // pixels
    constexpr std::size_t kPixelsPerByte = 10'000;                    // PNG packs up to 8,256 of one bit
#endif
    if (width > kMaxSide || height > kMaxSide) {
        return "too large";
    }
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return pixels > kAlwaysAllowed && pixels / kPixelsPerByte > bytes ? "too large for so few bytes" : "";
}

/// The name of an unsupported format, by its magic bytes; null for others.
const char* unsupported_format(std::string_view text) {
    if (text.starts_with("\xABKTX 20") || text.starts_with("\xABKTX 11")) {
        return "KTX, Basis Universal";
    }
    if (text.starts_with("DDS ")) {
        return "DDS";
    }
    // What stb_image subtracts from half-transparent pixels, it converts to bytes even where that is
    // negative.
    constexpr std::size_t kChannelsAt = 12;  // two bytes, the higher one first
    constexpr std::string_view kMostChannels("\0\3", 2);
    if (text.starts_with("8BPS") && text.size() > kChannelsAt &&
        text.substr(kChannelsAt, 2) > kMostChannels) {
        return "PSD with transparency";
    }
    return text.substr(0, 12).ends_with("ftypavif") ? "AVIF" : nullptr;
}

/// The format itself limits sides to 16,383 pixels.
std::optional<DecodedImage> decode_webp(std::span<const std::uint8_t> bytes, std::string& reason) {
    DecodedImage image;
    WebPBitstreamFeatures features{};
    if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK) {
        reason = "damaged WebP";
        return std::nullopt;
    }
    if (features.has_animation != 0) {
        reason = "animated WebP";
        return std::nullopt;
    }
    image.width = features.width;
    image.height = features.height;
    reason = why_too_large(image.width, image.height, bytes.size());
    if (!reason.empty()) {
        return std::nullopt;
    }
    reason = "damaged WebP";
    const std::size_t stride = static_cast<std::size_t>(image.width) * 4;
    image.rgba.resize(stride * static_cast<std::size_t>(image.height));
    const bool decoded = WebPDecodeRGBAInto(bytes.data(), bytes.size(), image.rgba.data(), image.rgba.size(),
                                            static_cast<int>(stride)) != nullptr;
    return decoded ? std::optional(std::move(image)) : std::nullopt;
}

/// CMYK as Adobe writes it, inverted; to RGBA.
void convert_cmyk(std::vector<std::uint8_t>& pixels) {
    constexpr unsigned kMax = 255;
    for (std::size_t at = 0; at < pixels.size(); at += 4) {
        for (std::size_t c = 0; c < 3; ++c) {
            pixels[at + c] = static_cast<std::uint8_t>(unsigned{pixels[at + c]} * pixels[at + 3] / kMax);
        }
        pixels[at + 3] = kMax;
    }
}

std::optional<DecodedImage> decode_jpeg(std::span<const std::uint8_t> bytes, std::string& reason) {
    const std::unique_ptr<void, decltype(&tjDestroy)> decoder(tjInitDecompress(), &tjDestroy);
    DecodedImage image;
    int sampling = 0;
    int colors = 0;
    const auto size = static_cast<unsigned long>(bytes.size());
    if (!decoder || tjDecompressHeader3(decoder.get(), bytes.data(), size, &image.width, &image.height,
                                        &sampling, &colors) != 0) {
        reason = "damaged JPEG";
        return std::nullopt;
    }
    reason = why_too_large(image.width, image.height, bytes.size());
    if (!reason.empty()) {
        return std::nullopt;
    }
    const bool is_cmyk = colors == TJCS_CMYK || colors == TJCS_YCCK;
    image.rgba.resize(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    if (tjDecompress2(decoder.get(), bytes.data(), size, image.rgba.data(), image.width, 0, image.height,
                      is_cmyk ? TJPF_CMYK : TJPF_RGBA, TJFLAG_ACCURATEDCT) != 0 &&
        tjGetErrorCode(decoder.get()) != TJERR_WARNING) {  // as of a file that is cut short
        reason = "damaged JPEG";
        return std::nullopt;
    }
    if (is_cmyk) {
        convert_cmyk(image.rgba);
    }
    return image;
}

std::optional<DecodedImage> decode(std::span<const std::uint8_t> bytes, std::string& reason) {
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        reason = "file too large";
        return std::nullopt;
    }
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("RIFF") && text.substr(0, 12).ends_with("WEBP")) {
        return decode_webp(bytes, reason);
    }
    if (text.starts_with("\xFF\xD8\xFF")) {
        return decode_jpeg(bytes, reason);
    }
    if (const char* format = unsupported_format(text)) {
        reason = format;
        return std::nullopt;
    }
    constexpr int kChannels = 4;
    DecodedImage image;
    const auto* data = bytes.data();
    const int size = static_cast<int>(bytes.size());
    if (stbi_info_from_memory(data, size, &image.width, &image.height, nullptr) != 0) {
        reason = why_too_large(image.width, image.height, bytes.size());
        if (!reason.empty()) {
            return std::nullopt;
        }
    }
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(data, size, &image.width, &image.height, nullptr, kChannels), &stbi_image_free);
    if (!pixels) {
        const char* why = stbi_failure_reason();  // empty for some truncated files
        reason = why != nullptr && *why != '\0' ? why : "damaged or in an unknown format";
        return std::nullopt;
    }
    const std::size_t components =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * kChannels;
    image.rgba.assign(pixels.get(), pixels.get() + components);
    return image;
}

}  // namespace

std::optional<DecodedImage> decode_image(std::span<const std::uint8_t> bytes, std::string& reason) {
    auto image = decode(bytes, reason);
    if (!image) {
        reason = "cannot be decoded (" + reason + "); use PNG, JPEG or WebP";
    }
    return image;
}

std::optional<DecodedImage> read_image(const SceneFolder& folder, const std::string& uri,
                                       std::string& reason) {
    const auto path = folder.find_image(uri);
    if (!path) {
        reason =
            "is missing or outside the folders a scene may read (its own and below, or textures/, "
            "materials/, images/, maps/ beside it)";
        return std::nullopt;
    }
    const auto bytes = read_bytes(*path);
    if (!bytes) {
        reason = "cannot be read";
        return std::nullopt;
    }
    return decode_image(*bytes, reason);
}

}  // namespace campuswalk::scene

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
