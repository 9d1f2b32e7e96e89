#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace campuswalk::scene {

/// 64-bit XXH3: detects damage, not forgery.
std::uint64_t checksum_of(std::span<const std::byte> bytes);
/// Of the concatenation of buffers.
std::uint64_t checksum_of(std::span<const std::span<const std::byte>> buffers);

/// 128-bit XXH3 that identifies contents. Not collision resistant against an adversary.
struct ContentHash {
    std::uint64_t high = 0;
    std::uint64_t low = 0;

    friend bool operator==(const ContentHash&, const ContentHash&) = default;
};

ContentHash hash_of(std::span<const std::byte> bytes);

/// 32 lower-case hexadecimal digits.
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
