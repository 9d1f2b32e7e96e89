#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace campuswalk::engine::render {

/// The visible pixels of one owner in an image.
struct VisiblePart {
    std::uint32_t owner = 0;
    std::size_t pixels = 0;
    /// The pixel farthest from other owners and from the image border. A horizontal step counts a quarter of
    /// a vertical one, as labels are wide.
    Eigen::Vector2d deepest = Eigen::Vector2d::Zero();
};

/// The visible owners below `count`, in ascending order. `owners` has one entry per pixel, rows of `width`
/// from top to bottom.
std::vector<VisiblePart> visible_parts(std::span<const std::uint32_t> owners, std::size_t width,
                                       std::uint32_t count);

}  // namespace campuswalk::engine::render
