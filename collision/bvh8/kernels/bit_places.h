#pragma once

#include <array>
#include <cstdint>

namespace campuswalk::collision {

/// By byte, the places of its set bits, lowest first, a byte each: what turns a mask into a list without a
/// jump for each bit.
inline constexpr std::array<std::uint64_t, 256> kBitPlaces = [] {
    std::array<std::uint64_t, 256> places{};
    for (unsigned byte = 0; byte < 256; ++byte) {
        unsigned found = 0;
        for (unsigned bit = 0; bit < 8; ++bit) {
            if ((byte >> bit & 1U) != 0) {
                places[byte] |= static_cast<std::uint64_t>(bit) << (8 * found++);
            }
        }
    }
    return places;
}();

}  // namespace campuswalk::collision
