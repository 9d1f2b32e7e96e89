#include "scene/import/decode_image.h"

#include <limits>
#include <memory>

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

namespace campuswalk::scene {

std::optional<DecodedImage> decode_image(std::span<const std::uint8_t> bytes, std::string& reason) {
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        reason = "file too large";
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
        reason = words != nullptr && *words != '\0' ? words : "damaged or of an unknown format";
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
