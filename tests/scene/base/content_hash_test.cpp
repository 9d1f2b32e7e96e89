#include "scene/base/content_hash.h"

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text));
}

/// The values are those of `xxhsum -H2` and `-H3` (xxhash 0.8.1) of the same bytes.
TEST(ContentHash, AgreesWithXxhsum) {
    EXPECT_EQ(checksum_of(bytes_of("campuswalk\n")), 0x3ea6e94f40d187a9U);
    ContentHasher hasher;
    hasher.add(bytes_of("campus"));
    hasher.add(bytes_of("walk\n"));
    EXPECT_EQ(to_string(hasher.result()), "e2da1d89695ee4387e162ffd3005ba8a");
    EXPECT_EQ(hash_of(bytes_of("campuswalk\n")), hasher.result());
}

TEST(ContentHash, DependsOnTextBoundaries) {
    ContentHasher one;
    one.add_text("ab");
    one.add_text("c");
    ContentHasher other;
    other.add_text("a");
    other.add_text("bc");
    EXPECT_NE(one.result(), other.result());
}

TEST(ContentHash, WritesLeadingZeros) {
    EXPECT_EQ(to_string(ContentHash{1, 0xAB}), "000000000000000100000000000000ab");
}

}  // namespace
}  // namespace campuswalk::scene
