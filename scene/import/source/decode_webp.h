#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "scene/import/source/decode_image.h"

namespace campuswalk::scene {

bool is_webp(std::span<const std::uint8_t> bytes);

/// The first frame, with the same limits as decode_image.
std::optional<DecodedImage> decode_webp(std::span<const std::uint8_t> bytes, std::string& reason);

}  // namespace campuswalk::scene
