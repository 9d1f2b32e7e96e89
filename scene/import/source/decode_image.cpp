#include "scene/import/source/decode_image.h"

#include <limits>
#include <memory>
#include <string_view>

#include <webp/decode.h>

// The only translation unit with stb_image's code; static, so that it can't clash with another copy.
#ifndef __clang_analyzer__  // not our code to fix
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#endif
#define STBI_NO_STDIO
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
#include <stb/stb_image.h>

namespace campuswalk::scene {
namespace {

/// The name of an unsupported format, by its magic bytes; null for others.
const char* unsupported_format(std::string_view text) {
    if (text.starts_with("\xABKTX 20") || text.starts_with("\xABKTX 11")) {
        return "KTX, Basis Universal";
    }
    if (text.starts_with("DDS ")) {
        return "DDS";
    }
    return text.substr(0, 12).ends_with("ftypavif") ? "AVIF" : nullptr;
}

/// The format itself limits sides to 16,383 pixels.
std::optional<DecodedImage> decode_webp(std::span<const std::uint8_t> bytes, std::string& reason) {
    DecodedImage image;
    WebPBitstreamFeatures features{};
    reason = "damaged WebP";
    if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK) {
        return std::nullopt;
    }
    if (features.has_animation != 0) {
        reason = "animated WebP";
        return std::nullopt;
    }
    image.width = features.width;
    image.height = features.height;
    const std::size_t stride = static_cast<std::size_t>(image.width) * 4;
    image.rgba.resize(stride * static_cast<std::size_t>(image.height));
    const bool decoded = WebPDecodeRGBAInto(bytes.data(), bytes.size(), image.rgba.data(), image.rgba.size(),
                                            static_cast<int>(stride)) != nullptr;
    return decoded ? std::optional(std::move(image)) : std::nullopt;
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
    if (const char* format = unsupported_format(text)) {
        reason = format;
        return std::nullopt;
    }
    constexpr int kChannels = 4;
    DecodedImage image;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &image.width, &image.height,
                              nullptr, kChannels),
        &stbi_image_free);
    if (!pixels) {
        const char* why = stbi_failure_reason();  // empty for some truncated files
        reason = why != nullptr && *why != '\0' ? why : "damaged or in an unknown format";
        return std::nullopt;
    }
    const std::size_t size =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * kChannels;
    image.rgba.assign(pixels.get(), pixels.get() + size);
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
