#include "scene/cache/content_hash.h"

#include <bit>

#include <nettle/hmac.h>
#include <nettle/sha2.h>

namespace campuswalk::scene {

namespace {

const std::uint8_t* octets(std::span<const std::byte> bytes) {
    return reinterpret_cast<const std::uint8_t*>(bytes.data());
}

}  // namespace

struct ContentHasher::State {
    sha256_ctx sha256;
};

ContentHasher::ContentHasher() : state_(std::make_unique<State>()) {
    sha256_init(&state_->sha256);
}
ContentHasher::~ContentHasher() = default;
ContentHasher::ContentHasher(ContentHasher&&) noexcept = default;
ContentHasher& ContentHasher::operator=(ContentHasher&&) noexcept = default;

void ContentHasher::add(std::span<const std::byte> bytes) {
    sha256_update(&state_->sha256, bytes.size(), octets(bytes));
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
    add(std::as_bytes(std::span(hash.bytes)));
}

ContentHash ContentHasher::result() const {
    sha256_ctx so_far = state_->sha256;
    ContentHash hash;
    sha256_digest(&so_far, hash.bytes.size(), hash.bytes.data());
    return hash;
}

ContentHash hash_of(std::span<const std::byte> bytes) {
    ContentHasher hasher;
    hasher.add(bytes);
    return hasher.result();
}

ContentHash keyed_hash_of(std::span<const std::byte> bytes, std::span<const std::byte> key) {
    hmac_sha256_ctx hmac;
    hmac_sha256_set_key(&hmac, key.size(), octets(key));
    hmac_sha256_update(&hmac, bytes.size(), octets(bytes));
    ContentHash hash;
    hmac_sha256_digest(&hmac, hash.bytes.size(), hash.bytes.data());
    return hash;
}

std::string to_string(const ContentHash& hash) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (const std::uint8_t byte : hash.bytes) {
        text += kDigits[byte >> 4U];
        text += kDigits[byte & 15U];
    }
    return text;
}

}  // namespace campuswalk::scene
