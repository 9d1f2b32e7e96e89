#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace campuswalk::scene {

/// SHA-256 (FIPS 180-4): identifies contents, even if somebody chose them to be mistaken for others.
struct ContentHash {
    std::array<std::uint8_t, 32> bytes{};

    friend bool operator==(const ContentHash&, const ContentHash&) = default;
};

ContentHash hash_of(std::span<const std::byte> bytes);

/// HMAC-SHA256 (RFC 2104): only somebody who has the key can compute it.
ContentHash keyed_hash_of(std::span<const std::byte> bytes, std::span<const std::byte> key);

/// 64 lower-case hexadecimal digits.
std::string to_string(const ContentHash& hash);

/// Hashes a sequence of values.
class ContentHasher {
public:
    ContentHasher();
    ~ContentHasher();
    ContentHasher(ContentHasher&&) noexcept;
    ContentHasher& operator=(ContentHasher&&) noexcept;

    void add(std::span<const std::byte> bytes);
    /// Includes the length, so that "ab", "c" and "a", "bc" differ.
    void add_text(std::string_view text);
    void add_number(std::uint64_t number);
    void add_number(double number);
    void add_hash(const ContentHash& hash);

    /// The hash so far; more may be added.
    ContentHash result() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace campuswalk::scene
