#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "collision/geometry/shapes.h"

namespace campuswalk::engine {

/// A square column of the world, by its number of cells along x and z.
struct GridCell {
    int x = 0;
    int z = 0;

    friend bool operator==(const GridCell&, const GridCell&) = default;
    friend auto operator<=>(const GridCell&, const GridCell&) = default;
};

/// For hash maps by cell.
struct GridCellHash {
    std::size_t operator()(const GridCell& cell) const {
        const std::uint64_t key = static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.x)) << 32U |
                                  static_cast<std::uint32_t>(cell.z);
        return std::hash<std::uint64_t>()(key);
    }
};

/// The cell with the lowest x and z of the square of `size` x `size` cells that this one is in; such squares
/// tile the world from its origin on.
inline GridCell first_of_square(const GridCell& cell, int size) {
    const auto first = [size](int at) {
        const int rest = at % size;
        return at - (rest < 0 ? rest + size : rest);
    };
    return {first(cell.x), first(cell.z)};
}

/// The directions that a cell is left in: first to the cells beside it, then to those across its corners.
struct GridDirection {
    int x = 0;
    int z = 0;
    collision::Vec3 unit;
};

inline constexpr double kDiagonal = 0.70710678118654757;  // sqrt(1/2)

inline const std::array<GridDirection, 8>& grid_directions() {
    static const std::array<GridDirection, 8> directions{{
        {1, 0, {1, 0, 0}},
        {0, 1, {0, 0, 1}},
        {-1, 0, {-1, 0, 0}},
        {0, -1, {0, 0, -1}},
        {1, 1, {kDiagonal, 0, kDiagonal}},
        {-1, 1, {-kDiagonal, 0, kDiagonal}},
        {-1, -1, {-kDiagonal, 0, -kDiagonal}},
        {1, -1, {kDiagonal, 0, -kDiagonal}},
    }};
    return directions;
}

/// Cells of one size, with a corner at the world's origin.
struct WalkGrid {
    double cell = 0.25;  ///< edge length, metres

    GridCell cell_at(double x, double z) const {
        return {static_cast<int>(std::floor(x / cell)), static_cast<int>(std::floor(z / cell))};
    }
    GridCell cell_at(const collision::Vec3& foot) const { return cell_at(foot.x(), foot.z()); }
    /// Of the cell, at height 0.
    collision::Vec3 center(const GridCell& c) const { return {(c.x + 0.5) * cell, 0.0, (c.z + 0.5) * cell}; }
};

}  // namespace campuswalk::engine
