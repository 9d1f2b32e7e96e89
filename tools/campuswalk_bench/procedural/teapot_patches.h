#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace campuswalk::tools::bench {

/// Martin Newell's teapot (University of Utah, 1975): 32 bicubic Bezier patches, Z-up. A patch has 16
/// control points in row-major order.
inline constexpr std::size_t kTeapotPoints = 290;
inline constexpr std::size_t kTeapotPatches = 32;

extern const std::array<std::array<double, 3>, kTeapotPoints> kTeapotControlPoints;
extern const std::array<std::array<std::uint16_t, 16>, kTeapotPatches> kTeapotPatchPoints;

}  // namespace campuswalk::tools::bench
