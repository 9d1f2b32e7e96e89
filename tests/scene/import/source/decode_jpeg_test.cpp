#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <turbojpeg.h>

#include "scene/import/source/decode_image.h"

namespace campuswalk::scene {
namespace {

constexpr int kSide = 40;

/// Four components a pixel, which change slowly.
std::vector<std::uint8_t> gradients() {
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            for (const int value : {6 * x, 6 * y, 3 * (x + y), 255}) {
                pixels.push_back(static_cast<std::uint8_t>(value));
            }
        }
    }
    return pixels;
}

std::vector<std::uint8_t> jpeg(const std::vector<std::uint8_t>& pixels, int format, int flags = 0) {
    const std::unique_ptr<void, decltype(&tjDestroy)> encoder(tjInitCompress(), &tjDestroy);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    constexpr int kQuality = 98;
    EXPECT_EQ(tjCompress2(encoder.get(), pixels.data(), kSide, 0, kSide, format, &bytes, &size, TJSAMP_444,
                          kQuality, flags),
              0);
    std::vector<std::uint8_t> file(bytes, bytes + size);
    tjFree(bytes);
    return file;
}

void expect_gradients(const std::vector<std::uint8_t>& file, const std::vector<std::uint8_t>& expected) {
    std::string reason;
    const auto image = decode_image(file, reason);
    ASSERT_TRUE(image) << reason;
    EXPECT_EQ(image->width, kSide);
    EXPECT_EQ(image->height, kSide);
    ASSERT_EQ(image->rgba.size(), expected.size());
    int worst = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        worst = std::max(worst, std::abs(image->rgba[i] - expected[i]));
    }
    EXPECT_LE(worst, 6);  // of 255: what the compression loses
}

TEST(DecodeJpeg, IsTheImageThatWasEncoded) {
    expect_gradients(jpeg(gradients(), TJPF_RGBA), gradients());
    expect_gradients(jpeg(gradients(), TJPF_RGBA, TJFLAG_PROGRESSIVE), gradients());
}

TEST(DecodeJpeg, ConvertsCmykAsAdobeWritesIt) {
    const std::vector<std::uint8_t> inverted = gradients();  // without black
    expect_gradients(jpeg(inverted, TJPF_CMYK), gradients());
}

TEST(DecodeJpeg, ShowsWhatThereIsOfATruncatedFile) {
    std::vector<std::uint8_t> file = jpeg(gradients(), TJPF_RGBA);
    file.resize(file.size() - file.size() / 10);
    std::string reason;
    EXPECT_TRUE(decode_image(file, reason));
    file.resize(100);
    EXPECT_FALSE(decode_image(file, reason));
    EXPECT_NE(reason.find("damaged JPEG"), std::string::npos);
}

TEST(DecodeJpeg, RefusesSidesBeyondTheLimit) {
    std::vector<std::uint8_t> file = jpeg(gradients(), TJPF_RGBA);
    for (std::size_t at = 0; at + 8 < file.size(); ++at) {
        if (file[at] == 0xFF && file[at + 1] == 0xC0) {  // SOF0: length, precision, height, width
            file[at + 5] = 0xFF;
            break;
        }
    }
    std::string reason;
    EXPECT_FALSE(decode_image(file, reason));
    EXPECT_NE(reason.find("too large"), std::string::npos);
}

}  // namespace
}  // namespace campuswalk::scene
