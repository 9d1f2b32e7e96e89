#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "scene/import/source/decode_image.h"
#include "scene/import/source/scene_folder.h"

namespace campuswalk::scene {

/// Decodes an image that a model names; on failure `reason` says what to do.
std::optional<DecodedImage> decode_image_bytes(std::span<const std::uint8_t> bytes, std::string& reason);

/// Likewise one in a file of its own.
std::optional<DecodedImage> read_image(const SceneFolder& folder, const std::string& uri,
                                       std::string& reason);

}  // namespace campuswalk::scene
