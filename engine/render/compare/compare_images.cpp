#include "engine/render/compare/compare_images.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/events/decimals.h"

namespace campuswalk::engine::render {
namespace {

/// Rounded down, so that an insufficient 0.96996 is not reported as 0.970.
std::string rounded_down(double value, int decimals) {
    double unit = 1.0;
    for (int i = 0; i < decimals; ++i) {
        unit *= 10.0;
    }
    return fixed(std::floor(value * unit) / unit, decimals);
}

std::string percent(double ratio) {
    return fixed(100.0 * ratio, 3) + " %";
}

}  // namespace

ImageComparison compare_images(const Image& a, const Image& b, const ImageTolerance& tolerance) {
    assert(a.width == b.width && a.height == b.height && !a.rgba.empty());
    ImageComparison comparison;
    if (a.rgba == b.rgba && tolerance.masks.empty()) {
        comparison.pixels.verdicts.assign(a.rgba.size() / 4, PixelVerdict::same);
        return comparison;
    }
    const ImageMask mask(a.width, a.height, tolerance.masks);
    comparison.pixels = pixel_difference(a, b, tolerance.threshold, mask);
    comparison.ratio = static_cast<double>(comparison.pixels.different) /
                       static_cast<double>(comparison.pixels.verdicts.size());
    comparison.tiles = tile_similarities(a, b, mask);
    comparison.worst = *std::ranges::min_element(comparison.tiles, {}, &TileSimilarity::ssim);
    return comparison;
}

std::string describe_violations(const ImageComparison& comparison, const ImageTolerance& tolerance) {
    std::string why;
    const auto add = [&](const std::string& reason) { why += (why.empty() ? "" : "; ") + reason; };
    const std::size_t pixels = comparison.pixels.different;
    const bool unlimited = !tolerance.max_diff_pixels && !tolerance.max_diff_pixel_ratio;
    const std::size_t most = tolerance.max_diff_pixels ? static_cast<std::size_t>(*tolerance.max_diff_pixels)
                                                       : (unlimited ? 0 : pixels);
    if (pixels > most) {
        add(std::to_string(pixels) + (pixels == 1 ? " pixel differs (" : " pixels differ (") +
            percent(comparison.ratio) + "), the limit is " + std::to_string(most));
    }
    if (tolerance.max_diff_pixel_ratio && comparison.ratio > *tolerance.max_diff_pixel_ratio) {
        add(percent(comparison.ratio) + " of the pixels differ, the limit is " +
            percent(*tolerance.max_diff_pixel_ratio));
    }
    if (comparison.worst.ssim < tolerance.min_tile_ssim) {
        const PixelBox& box = comparison.worst.box;
        const auto dissimilar = std::ranges::count_if(comparison.tiles, [&](const TileSimilarity& tile) {
            return tile.ssim < tolerance.min_tile_ssim;
        });
        add("the tile of " + std::to_string(box.width) + "x" + std::to_string(box.height) + " pixels at " +
            std::to_string(box.x) + "," + std::to_string(box.y) + " has a similarity of " +
            rounded_down(comparison.worst.ssim, 3) + ", the minimum is " + fixed(tolerance.min_tile_ssim, 3) +
            (dissimilar > 1 ? " (" + std::to_string(dissimilar) + " of " +
                                  std::to_string(comparison.tiles.size()) + " tiles)"
                            : ""));
    }
    return why;
}

}  // namespace campuswalk::engine::render
