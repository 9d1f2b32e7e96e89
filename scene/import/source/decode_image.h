#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/import/source/scene_folder.h"

namespace campuswalk::scene {

/// 8-bit RGBA, top row first.
struct DecodedImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

/// Decodes PNG, JPEG, WebP, BMP, TGA, GIF (first frame) and opaque PSD, up to 16,384 pixels a side, and
/// beyond 16 million pixels only with a byte for every 10,000 of them. On failure returns nullopt and a
/// `reason` that completes "texture X …" and says what to do.
std::optional<DecodedImage> decode_image(std::span<const std::uint8_t> bytes, std::string& reason);

/// The same for an image file that a scene refers to.
std::optional<DecodedImage> read_image(const SceneFolder& folder, const std::string& uri,
                                       std::string& reason);

}  // namespace campuswalk::scene
