#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace campuswalk::engine::render {

/// What an image shows of one owner.
struct VisiblePart {
    std::uint32_t owner = 0;
    std::size_t pixels = 0;
    /// The pixel that is deepest inside: the farthest from whatever isn't the owner's, and from the edges of
    /// the image. A step across counts a quarter of one up or down, because names are wide.
    Eigen::Vector2d deepest = Eigen::Vector2d::Zero();
};

/// `owners`: one a pixel, rows from top to bottom, `width` in each. By owner; those below `count` that are
/// seen, in their order.
std::vector<VisiblePart> visible_parts(std::span<const std::uint32_t> owners, std::size_t width,
                                       std::uint32_t count);

}  // namespace campuswalk::engine::render
