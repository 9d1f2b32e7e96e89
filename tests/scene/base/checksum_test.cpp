#include "scene/base/checksum.h"

#include <string_view>

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

/// The value is that of `xxhsum -H3` (xxhash 0.8.1) of the same bytes.
TEST(Checksum, AgreesWithXxhsum) {
    const auto bytes = std::as_bytes(std::span(std::string_view("campuswalk\n")));
    EXPECT_EQ(checksum_of(bytes), 0x3ea6e94f40d187a9U);
    EXPECT_EQ(checksum_of(std::array{bytes.first(4), bytes.subspan(4)}), 0x3ea6e94f40d187a9U);
}

}  // namespace
}  // namespace campuswalk::scene
