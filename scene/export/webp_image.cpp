#include "scene/export/webp_image.h"

#include <webp/encode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace campuswalk::scene {

namespace {

struct FreeWebP {
    void operator()(std::uint8_t* bytes) const { WebPFree(bytes); }
};

std::string taken(std::uint8_t* bytes, std::size_t size) {
    const std::unique_ptr<std::uint8_t, FreeWebP> owned(bytes);
    if (size == 0) {
        throw std::runtime_error("a picture can't be encoded as WebP: it is too large");
    }
    return {bytes, bytes + size};
}

/// Pixels `first` to `end` of the source that pixel `i` of `count` covers.
struct Covered {
    int first = 0;
    int end = 0;
};

Covered covered(int i, int count, int source) {
    const auto at = [&](int k) { return static_cast<int>(static_cast<std::int64_t>(k) * source / count); };
    return {at(i), std::max(at(i) + 1, at(i + 1))};
}

}  // namespace

Pixels shrunk_to_fit(const PixelView& image, int width, int height) {
    const double scale =
        std::min({1.0, static_cast<double>(width) / image.width, static_cast<double>(height) / image.height});
    Pixels small;
    small.width = std::max(1, static_cast<int>(std::lround(image.width * scale)));
    small.height = std::max(1, static_cast<int>(std::lround(image.height * scale)));
    if (small.width == image.width && small.height == image.height) {
        small.rgba.assign(image.rgba.begin(), image.rgba.end());
        return small;
    }
    small.rgba.reserve(4U * static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height));
    for (int y = 0; y < small.height; ++y) {
        const Covered rows = covered(y, small.height, image.height);
        for (int x = 0; x < small.width; ++x) {
            const Covered columns = covered(x, small.width, image.width);
            std::array<std::uint64_t, 4> sums = {};
            for (int row = rows.first; row < rows.end; ++row) {
                for (int column = columns.first; column < columns.end; ++column) {
                    const std::size_t at =
                        4U * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                              static_cast<std::size_t>(column));
                    for (std::size_t k = 0; k < 4; ++k) {
                        sums[k] += image.rgba[at + k];
                    }
                }
            }
            const auto count = static_cast<std::uint64_t>(rows.end - rows.first) *
                               static_cast<std::uint64_t>(columns.end - columns.first);
            for (const std::uint64_t sum : sums) {
                small.rgba.push_back(static_cast<std::uint8_t>((sum + count / 2) / count));
            }
        }
    }
    return small;
}

std::string encode_webp(const PixelView& image, float quality) {
    std::uint8_t* bytes = nullptr;
    const std::size_t size =
        WebPEncodeRGBA(image.rgba.data(), image.width, image.height, 4 * image.width, quality, &bytes);
    return taken(bytes, size);
}

std::string encode_webp_lossless(const PixelView& image) {
    std::uint8_t* bytes = nullptr;
    const std::size_t size =
        WebPEncodeLosslessRGBA(image.rgba.data(), image.width, image.height, 4 * image.width, &bytes);
    return taken(bytes, size);
}

}  // namespace campuswalk::scene
