#include "collision/mesh/mesh_extent.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>

namespace campuswalk::collision {

namespace {

constexpr std::size_t kBlock = 16;  ///< positions that are compared side by side
// `coordinates` sees all positions as one array of floats.
static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));

std::span<const float> coordinates(std::span<const Eigen::Vector3f> positions) {
    return {positions.empty() ? nullptr : positions.front().data(), 3 * positions.size()};
}

}  // namespace

std::uint32_t highest_vertex(std::span<const std::array<std::uint32_t, 3>> triangles) {
    std::uint32_t highest = 0;
    for (const auto& t : triangles) {
        highest = std::max(highest, std::max(t[0], std::max(t[1], t[2])));
    }
    return highest;
}

float largest_coordinate(std::span<const Eigen::Vector3f> positions) {
    // Without the sign, floats are ordered like their bits, with infinity and NaN above all others.
    constexpr std::uint32_t kMagnitudeMask = 0x7FFFFFFF;
    std::uint32_t largest = 0;
    for (const float coordinate : coordinates(positions)) {
        largest = std::max(largest, std::bit_cast<std::uint32_t>(coordinate) & kMagnitudeMask);
    }
    constexpr auto kInfinity = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::infinity());
    return std::bit_cast<float>(std::min(largest, kInfinity));
}

Aabb box_of(std::span<const Eigen::Vector3f> positions) {
    std::array<float, 3 * kBlock> low;
    std::array<float, 3 * kBlock> high;
    low.fill(std::numeric_limits<float>::infinity());
    high.fill(-std::numeric_limits<float>::infinity());
    const std::span<const float> all = coordinates(positions);
    const std::size_t blocks = all.size() / low.size();
    for (std::size_t b = 0; b < blocks; ++b) {
        const float* block = all.data() + b * low.size();
        for (std::size_t i = 0; i < low.size(); ++i) {
            low[i] = std::min(low[i], block[i]);
            high[i] = std::max(high[i], block[i]);
        }
    }
    Aabb box;
    for (std::size_t p = blocks * kBlock; p < positions.size(); ++p) {
        box.extend(positions[p].cast<double>());
    }
    for (std::size_t i = 0; blocks > 0 && i < kBlock; ++i) {
        box.extend(Eigen::Vector3f(low[3 * i], low[3 * i + 1], low[3 * i + 2]).cast<double>());
        box.extend(Eigen::Vector3f(high[3 * i], high[3 * i + 1], high[3 * i + 2]).cast<double>());
    }
    return box;
}

}  // namespace campuswalk::collision
