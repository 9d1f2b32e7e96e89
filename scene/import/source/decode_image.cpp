#include "scene/import/source/decode_image.h"

#include <limits>
#include <memory>
#include <string_view>

// The one place that holds stb_image's code; static, so that it can't clash with another copy in a program.
#ifndef __clang_analyzer__  // its findings in there are not ours to fix
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
// g++ 12 at -O3 with assertions takes its reader's members for uninitialised.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <stb/stb_image.h>

#include "scene/import/source/decode_webp.h"

namespace campuswalk::scene {
namespace {

/// Formats for which there is no library here, by the first bytes.
const char* unread_format(std::span<const std::uint8_t> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("\xABKTX 20") || text.starts_with("\xABKTX 11")) {
        return "KTX, Basis Universal";
    }
    if (text.starts_with("DDS ")) {
        return "DDS";
    }
    return text.substr(0, 12).ends_with("ftypavif") ? "AVIF" : nullptr;
}

}  // namespace

std::optional<DecodedImage> decode_image(std::span<const std::uint8_t> bytes, std::string& reason) {
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        reason = "file too large";
        return std::nullopt;
    }
    if (is_webp(bytes)) {
        return decode_webp(bytes, reason);
    }
    if (const char* format = unread_format(bytes)) {
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
        const char* words = stbi_failure_reason();
        // It has no words for some files that end early.
        reason = words != nullptr && *words != '\0' ? words : "damaged or in an unknown format";
        return std::nullopt;
    }
    const std::size_t size =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * kChannels;
    image.rgba.assign(pixels.get(), pixels.get() + size);
    return image;
}

}  // namespace campuswalk::scene

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
