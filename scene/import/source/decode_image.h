#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace campuswalk::scene {

/// Pixels of a decoded image: 8-bit RGBA, rows from top to bottom.
struct DecodedImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

/// Decodes PNG, JPEG, WebP, BMP, TGA, GIF (first frame) and PSD; sides up to 16,384 pixels. On failure gives
/// nullopt and says in `reason` why.
std::optional<DecodedImage> decode_image(std::span<const std::uint8_t> bytes, std::string& reason);

}  // namespace campuswalk::scene
