#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace campuswalk::scene::gltf {

/// RFC 4648 base 64, padding optional; nullopt when a character is none of its alphabet.
std::optional<std::vector<std::uint8_t>> decode_base64(std::string_view text);

}  // namespace campuswalk::scene::gltf
