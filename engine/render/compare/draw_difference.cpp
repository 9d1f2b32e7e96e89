#include <algorithm>
#include <array>
#include <utility>

#include "engine/render/compare/compare_images.h"

namespace campuswalk::engine::render {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

constexpr Rgb kRed = {220, 0, 0};
constexpr Rgb kYellow = {255, 200, 0};
constexpr Rgb kMagenta = {200, 0, 200};
constexpr int kHatch = 8;  ///< pixels between lines

std::uint8_t pale_grey(const Image& image, std::size_t offset) {
    const int brightness =
        (77 * image.rgba[offset] + 150 * image.rgba[offset + 1] + 29 * image.rgba[offset + 2]) / 256;
    return static_cast<std::uint8_t>(200 + brightness * 55 / 255);
}

/// From white (no difference) to orange at the threshold; even the smallest difference is visible.
Rgb close_color(double share) {
    const double strength = 0.25 + 0.75 * std::min(share, 1.0);
    return {255, static_cast<std::uint8_t>(255 - 115 * strength),
            static_cast<std::uint8_t>(255 - 255 * strength)};
}

class DifferenceImage {
public:
    DifferenceImage(const Image& a, const Image& b) : a_(a), b_(b), drawn_(a) {}

    void pixel(int x, int y, PixelVerdict verdict, double threshold) {
        const std::size_t offset = a_.offset(x, y);
        const std::uint8_t grey = pale_grey(a_, offset);
        switch (verdict) {
            case PixelVerdict::same:
                put(offset, {grey, grey, grey});
                break;
            case PixelVerdict::close:
                put(offset, close_color(color_distance(&a_.rgba[offset], &b_.rgba[offset]) / threshold));
                break;
            case PixelVerdict::antialiased:
                put(offset, kYellow);
                break;
            case PixelVerdict::different:
                put(offset, kRed);
                break;
            case PixelVerdict::masked: {
                const auto dark = static_cast<std::uint8_t>((x + y) % kHatch == 0 ? 120 : grey);
                put(offset, {dark, dark, static_cast<std::uint8_t>(std::min(255, dark + 20))});
                break;
            }
        }
    }

    void border(const PixelBox& box) {
        const int right = box.x + box.width - 1;
        const int bottom = box.y + box.height - 1;
        for (int x = box.x; x <= right; ++x) {
            put(a_.offset(x, box.y), kMagenta);
            put(a_.offset(x, bottom), kMagenta);
        }
        for (int y = box.y; y <= bottom; ++y) {
            put(a_.offset(box.x, y), kMagenta);
            put(a_.offset(right, y), kMagenta);
        }
    }

    Image take() { return std::move(drawn_); }

private:
    void put(std::size_t offset, const Rgb& color) {
        std::copy(color.begin(), color.end(), drawn_.rgba.begin() + static_cast<std::ptrdiff_t>(offset));
    }

    const Image& a_;
    const Image& b_;
    Image drawn_;
};

}  // namespace

Image draw_difference(const Image& a, const Image& b, const ImageComparison& comparison,
                      const ImageTolerance& tolerance) {
    DifferenceImage drawn(a, b);
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            drawn.pixel(x, y, comparison.pixels.verdicts[a.offset(x, y) / 4], tolerance.threshold);
        }
    }
    for (const TileSimilarity& tile : comparison.tiles) {
        if (tile.ssim < tolerance.min_tile_ssim) {
            drawn.border(tile.box);
        }
    }
    return drawn.take();
}

}  // namespace campuswalk::engine::render
