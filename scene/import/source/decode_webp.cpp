#include "scene/import/source/decode_webp.h"

#include <cstring>

#include <webp/decode.h>

namespace campuswalk::scene {

bool is_webp(std::span<const std::uint8_t> bytes) {
    return bytes.size() >= 12 && std::memcmp(bytes.data(), "RIFF", 4) == 0 &&
           std::memcmp(bytes.data() + 8, "WEBP", 4) == 0;
}

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
    // The format itself ends at 16,383 pixels a side.
    image.width = features.width;
    image.height = features.height;
    const std::size_t stride = static_cast<std::size_t>(image.width) * 4;
    image.rgba.resize(stride * static_cast<std::size_t>(image.height));
    if (WebPDecodeRGBAInto(bytes.data(), bytes.size(), image.rgba.data(), image.rgba.size(),
                           static_cast<int>(stride)) == nullptr) {
        reason = "damaged WebP";
        return std::nullopt;
    }
    return image;
}

}  // namespace campuswalk::scene
