#pragma once

#include <cstdint>
#include <span>

namespace campuswalk::scene {

/// Whether an OBJ's material file scales, moves or distorts an image: options -s, -o and -t of its maps,
/// which assimp 5.2.5 skips.
bool moves_images(std::span<const std::uint8_t> mtl);

}  // namespace campuswalk::scene
