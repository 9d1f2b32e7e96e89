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

/// How far two images may be apart and still count as the same. Both rules hold.
struct ImageTolerance {
    /// Colours closer than this are the same: 0 is the same bytes, 1 the two farthest apart. 0.2 is beyond
    /// what another processor or Mesa version makes of a surface.
    double threshold = 0.2;
    /// Pixels whose colours differ by more; where both are set, both hold, where none is, there may be none.
    std::optional<int> max_diff_pixels;
    std::optional<double> max_diff_pixel_ratio;  ///< of all pixels
    /// The structural similarity that every tile of 64 pixels must have, 1 for the same. It finds what stays
    /// below `threshold`: a shadow that is gone, a wall that moved by a hand's breadth.
    double min_tile_ssim = 0.97;
    std::vector<PixelBox> masks;  ///< what is in there isn't looked at
};

/// What is said about a tolerance in one place; what isn't said stays as it was.
struct ToleranceChanges {
    std::optional<double> threshold;
    std::optional<int> max_diff_pixels;
    std::optional<double> max_diff_pixel_ratio;
    std::optional<double> min_tile_ssim;
    std::vector<PixelBox> masks;  ///< added to those there are
};

ImageTolerance changed(ImageTolerance tolerance, const ToleranceChanges& changes);

}  // namespace campuswalk::engine
