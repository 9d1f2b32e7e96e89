#include "engine/script/image_tolerance.h"

namespace campuswalk::engine {

ImageTolerance changed(ImageTolerance tolerance, const ToleranceChanges& changes) {
    tolerance.threshold = changes.threshold.value_or(tolerance.threshold);
    if (changes.max_diff_pixels) {
        tolerance.max_diff_pixels = changes.max_diff_pixels;
    }
    if (changes.max_diff_pixel_ratio) {
        tolerance.max_diff_pixel_ratio = changes.max_diff_pixel_ratio;
    }
    tolerance.min_tile_ssim = changes.min_tile_ssim.value_or(tolerance.min_tile_ssim);
    tolerance.masks.insert(tolerance.masks.end(), changes.masks.begin(), changes.masks.end());
    return tolerance;
}

}  // namespace campuswalk::engine
