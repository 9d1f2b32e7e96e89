#pragma once

#include <optional>
#include <span>

#include <Eigen/Geometry>

namespace campuswalk::engine::render {

/// The first box of half size `half` that lies in `area` and overlaps none of `taken`: centred on `at`, or
/// moved from there by one of `shifts`, in units of `half`. None if there is no such box. Pixels.
std::optional<Eigen::AlignedBox2d> free_box(const Eigen::AlignedBox2d& area, const Eigen::Vector2d& at,
                                            const Eigen::Vector2d& half,
                                            std::span<const Eigen::Vector2d> shifts,
                                            std::span<const Eigen::AlignedBox2d> taken);

}  // namespace campuswalk::engine::render
