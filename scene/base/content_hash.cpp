#include "scene/base/content_hash.h"

#include <array>
#include <bit>

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

ContentHash hash_of(std::span<const std::byte> bytes) {
    const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
    return {hash.high64, hash.low64};
}

std::string to_string(const ContentHash& hash) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (const std::uint64_t half : {hash.high, hash.low}) {
        for (int shift = 60; shift >= 0; shift -= 4) {
            text += kDigits[half >> static_cast<unsigned>(shift) & 15U];
        }
    }
    return text;
}

struct ContentHasher::State {
    XXH3_state_t xxh;
};

ContentHasher::ContentHasher() : state_(std::make_unique<State>()) {
    XXH3_128bits_reset(&state_->xxh);
}
ContentHasher::~ContentHasher() = default;
ContentHasher::ContentHasher(ContentHasher&&) noexcept = default;
ContentHasher& ContentHasher::operator=(ContentHasher&&) noexcept = default;

void ContentHasher::add(std::span<const std::byte> bytes) {
    XXH3_128bits_update(&state_->xxh, bytes.data(), bytes.size());
}

void ContentHasher::add_text(std::string_view text) {
    add_number(std::uint64_t{text.size()});
    add(std::as_bytes(std::span(text)));
}

void ContentHasher::add_number(std::uint64_t number) {
    add(std::as_bytes(std::span(&number, 1)));
}

void ContentHasher::add_number(double number) {
    add_number(std::bit_cast<std::uint64_t>(number));
}

void ContentHasher::add_hash(const ContentHash& hash) {
    add_number(hash.high);
    add_number(hash.low);
}

ContentHash ContentHasher::result() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(&state_->xxh);
    return {hash.high64, hash.low64};
}

}  // namespace campuswalk::scene
