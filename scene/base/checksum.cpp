#include "scene/base/checksum.h"

// Header-only, so that neither we nor our users link libxxhash.
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace campuswalk::scene {

std::uint64_t checksum_of(std::span<const std::byte> bytes) {
    return XXH3_64bits(bytes.data(), bytes.size());
}

std::uint64_t checksum_of(std::span<const std::span<const std::byte>> buffers) {
    XXH3_state_t state;
    XXH3_64bits_reset(&state);
    for (const std::span<const std::byte> buffer : buffers) {
        XXH3_64bits_update(&state, buffer.data(), buffer.size());
    }
    return XXH3_64bits_digest(&state);
}

}  // namespace campuswalk::scene
