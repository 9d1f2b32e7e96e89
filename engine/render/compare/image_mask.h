#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/script/image_tolerance.h"

namespace campuswalk::engine::render {

/// The pixels of an image that comparisons ignore.
class ImageMask {
public:
    /// Boxes may extend beyond the image.
    ImageMask(int width, int height, std::span<const PixelBox> boxes);

    bool empty() const { return hidden_.empty(); }
    bool hides(int x, int y) const {
        return !hidden_.empty() && hidden_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                           static_cast<std::size_t>(x)] != 0;
    }

private:
    int width_;
    std::vector<std::uint8_t> hidden_;  ///< one per pixel, row-major; empty without boxes
};

}  // namespace campuswalk::engine::render
