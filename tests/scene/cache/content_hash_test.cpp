#include "scene/cache/content_hash.h"

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text));
}

/// FIPS 180-2, appendix B.2.
TEST(ContentHash, IsSha256) {
    constexpr std::string_view kMessage = "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq";
    constexpr std::string_view kDigest = "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1";
    ContentHasher hasher;
    hasher.add(bytes_of(kMessage.substr(0, 10)));
    EXPECT_NE(to_string(hasher.result()), kDigest);
    hasher.add(bytes_of(kMessage.substr(10)));
    EXPECT_EQ(to_string(hasher.result()), kDigest);
    EXPECT_EQ(hash_of(bytes_of(kMessage)), hasher.result());
}

/// RFC 4231, test cases 2 and 6: a short key, and one that is longer than a block.
TEST(ContentHash, WithAKeyIsHmacSha256) {
    EXPECT_EQ(to_string(keyed_hash_of(bytes_of("what do ya want for nothing?"), bytes_of("Jefe"))),
              "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843");
    EXPECT_EQ(to_string(keyed_hash_of(bytes_of("Test Using Larger Than Block-Size Key - Hash Key First"),
                                      bytes_of(std::string(131, '\xAA')))),
              "60e431591ee0b67f0d8a26aacbf5b77f8e0bc6213728c5140546040f0ee37f54");
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

}  // namespace
}  // namespace campuswalk::scene
