#pragma once

#include <optional>
#include <vector>

namespace campuswalk::engine {

/// A rectangle of an image, in pixels from its upper left corner.
struct PixelBox {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// How much two images may differ and still count as the same. Both rules must hold.
struct ImageTolerance {
    /// Colours closer than this count as equal: 0 means the same bytes, 1 the two farthest apart. 0.2 is more
    /// than another processor or Mesa version changes on a surface.
    double threshold = 0.2;
    /// Limits on the pixels whose colours differ by more; with neither of them there may be no such pixel.
    std::optional<int> max_diff_pixels;
    std::optional<double> max_diff_pixel_ratio;  ///< of all pixels
    /// The structural similarity that every tile of 64 pixels must have; 1 means equal. It finds differences
    /// below `threshold`: a missing shadow, a wall that moved by a hand's breadth.
    double min_tile_ssim = 0.97;
    std::vector<PixelBox> masks;  ///< pixels in these are ignored
};

/// The fields of a tolerance that are set in one place; the others stay unchanged.
struct ToleranceChanges {
    std::optional<double> threshold;
    std::optional<int> max_diff_pixels;
    std::optional<double> max_diff_pixel_ratio;
    std::optional<double> min_tile_ssim;
    std::vector<PixelBox> masks;  ///< added to the existing ones
};

ImageTolerance changed(ImageTolerance tolerance, const ToleranceChanges& changes);

}  // namespace campuswalk::engine
