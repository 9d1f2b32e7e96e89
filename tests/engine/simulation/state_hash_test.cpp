#include "engine/simulation/state_hash.h"

#include <bit>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace campuswalk::engine {
namespace {

/// FNV-1a over bytes, with the decimal constants of its specification.
std::uint64_t fnv1a(const std::string& bytes) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char c : bytes) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 1099511628211ULL;
    }
    return hash;
}

/// Least significant byte first.
std::string bytes_of(std::uint64_t bits) {
    std::string bytes;
    for (int i = 0; i < 8; ++i) {
        bytes += static_cast<char>(bits % 256);
        bits /= 256;
    }
    return bytes;
}

template <typename... Values>
std::uint64_t hash_of(const Values&... values) {
    StateHash hash;
    (hash.add(values), ...);
    return hash.value();
}

TEST(StateHash, ReferenceYieldsThePublishedValues) {
    EXPECT_EQ(fnv1a(""), 0xcbf29ce484222325ULL);
    EXPECT_EQ(fnv1a("a"), 0xaf63dc4c8601ec8cULL);
    EXPECT_EQ(fnv1a("foobar"), 0x85944171f73967e8ULL);
}

TEST(StateHash, IsFnv1aOverTheAddedBytes) {
    EXPECT_EQ(StateHash().value(), fnv1a(""));
    constexpr std::uint64_t kBits = 0x0123456789abcdefULL;
    EXPECT_EQ(hash_of(kBits), fnv1a(bytes_of(kBits)));
    EXPECT_EQ(hash_of(1.5), fnv1a(bytes_of(std::bit_cast<std::uint64_t>(1.5))));
    EXPECT_EQ(hash_of(Eigen::Vector3d(1.0, -2.0, 0.25)), fnv1a(bytes_of(std::bit_cast<std::uint64_t>(1.0)) +
                                                               bytes_of(std::bit_cast<std::uint64_t>(-2.0)) +
                                                               bytes_of(std::bit_cast<std::uint64_t>(0.25))));
    EXPECT_EQ(hash_of(std::string_view("foobar")), fnv1a("foobar" + bytes_of(6)));
}

TEST(StateHash, DependsOnEveryBitOfANumber) {
    constexpr std::uint64_t kBase = 0x3ff123456789abcdULL;
    std::set<std::uint64_t> as_integers = {hash_of(kBase)};
    std::set<std::uint64_t> as_doubles = {hash_of(std::bit_cast<double>(kBase))};
    for (int bit = 0; bit < 64; ++bit) {
        const std::uint64_t flipped = kBase ^ (std::uint64_t{1} << bit);
        as_integers.insert(hash_of(flipped));
        as_doubles.insert(hash_of(std::bit_cast<double>(flipped)));
    }
    EXPECT_EQ(as_integers.size(), 65U);
    EXPECT_EQ(as_doubles.size(), 65U);
}

TEST(StateHash, DependsOnEveryBitOfAString) {
    const std::string base = "library/door";
    std::set<std::uint64_t> seen = {hash_of(std::string_view(base))};
    for (std::size_t i = 0; i < base.size(); ++i) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string flipped = base;
            flipped[i] = static_cast<char>(flipped[i] ^ (1 << bit));
            seen.insert(hash_of(std::string_view(flipped)));
        }
    }
    EXPECT_EQ(seen.size(), 1 + 8 * base.size());
}

TEST(StateHash, DependsOnOrderAndOnWhereAStringEnds) {
    EXPECT_NE(hash_of(1.0, 2.0), hash_of(2.0, 1.0));
    EXPECT_NE(hash_of(std::string_view("ab"), std::string_view("c")),
              hash_of(std::string_view("a"), std::string_view("bc")));
    EXPECT_NE(hash_of(std::string_view("")), StateHash().value());
}

TEST(StateHash, TreatsBothZerosAsEqual) {
    EXPECT_EQ(hash_of(-0.0), hash_of(0.0));
    EXPECT_NE(hash_of(5e-324), hash_of(0.0));
}

}  // namespace
}  // namespace campuswalk::engine
