#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace campuswalk::scene {

/// XXH3 over bytes, as fast as memory: 64 bits against damage. Who forges a file can forge this too.
std::uint64_t checksum_of(std::span<const std::byte> bytes);
/// The same of bytes that lie in several places, one part after the other.
std::uint64_t checksum_of(std::span<const std::span<const std::byte>> parts);

/// 128 bits that name contents: two that differ have the same with a chance of 2^-128, unless somebody
/// searched for them.
struct ContentHash {
    std::uint64_t high = 0;
    std::uint64_t low = 0;

    friend bool operator==(const ContentHash&, const ContentHash&) = default;
};

ContentHash hash_of(std::span<const std::byte> bytes);

/// 32 lower-case hexadecimal digits.
std::string to_string(const ContentHash& hash);

/// Hashes what is added to it, one after the other.
class ContentHasher {
public:
    ContentHasher();
    ~ContentHasher();
    ContentHasher(ContentHasher&&) noexcept;
    ContentHasher& operator=(ContentHasher&&) noexcept;

    void add(std::span<const std::byte> bytes);
    /// With its length, so that "ab", "c" and "a", "bc" differ.
    void add_text(std::string_view text);
    void add_number(std::uint64_t number);
    void add_number(double number);
    void add_hash(const ContentHash& hash);

    /// Of all that was added; more may follow.
    ContentHash result() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace campuswalk::scene
