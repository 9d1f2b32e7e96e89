#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace campuswalk::scene {

/// 64-bit XXH3: detects damage, not forgery.
std::uint64_t checksum_of(std::span<const std::byte> bytes);
/// Of the concatenation of buffers.
std::uint64_t checksum_of(std::span<const std::span<const std::byte>> buffers);

}  // namespace campuswalk::scene
