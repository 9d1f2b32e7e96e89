#include "engine/render/sequence/frame_bytes.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace campuswalk::engine::render::test {
namespace {

Frame small_frame() {
    Frame frame{{3, 2, {}}, 70'000'000'000, 0.1};
    for (int i = 0; i < 24; ++i) {
        frame.image.rgba.push_back(static_cast<std::uint8_t>(i == 5 ? 0 : 200 + i));
    }
    return frame;
}

TEST(FrameBytes, RoundTrip) {
    const Frame back = deserialize_frame(serialize(small_frame()));
    EXPECT_EQ(back.number, small_frame().number);
    EXPECT_EQ(back.time, small_frame().time);
    EXPECT_EQ(back.image.width, 3);
    EXPECT_EQ(back.image.height, 2);
    EXPECT_EQ(back.image.rgba, small_frame().image.rgba);
}

TEST(FrameBytes, InvalidBytesAreRejected) {
    const std::string bytes = serialize(small_frame());
    EXPECT_THROW(deserialize_frame(""), std::runtime_error);
    EXPECT_THROW(deserialize_frame(bytes.substr(0, 20)), std::runtime_error);
    EXPECT_THROW(deserialize_frame(bytes.substr(0, bytes.size() - 1)), std::runtime_error);
    EXPECT_THROW(deserialize_frame(bytes + "x"), std::runtime_error);
    EXPECT_THROW(deserialize_frame(serialize({{-1, -2, {}}, 0, 0.0})), std::runtime_error);
}

}  // namespace
}  // namespace campuswalk::engine::render::test
