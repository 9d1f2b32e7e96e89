#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "collision/bvh8/bvh8.h"
#include "collision/bvh8/bvh8_split.h"
#include "collision/bvh8/lane_bounds.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

/// A leaf's triangles and which of its corners they have.
struct LeafTriangles {
    std::array<std::uint32_t, kLeafTriangles> triangle{};
    std::array<std::array<std::uint8_t, kLeafTriangles>, 3> vertex_of{};  ///< by corner, then triangle
    std::uint8_t triangles = 0;
    std::uint8_t vertices = 0;
};

/// Puts triangles into leaves. Made once for a mesh and used for one leaf after the other.
class LeafMaker {
public:
    explicit LeafMaker(const TriangleMesh& mesh) : mesh_(mesh), place_of_(mesh.positions.size()) {}

    /// False if there are too many triangles for a leaf or too many corners.
    bool make(std::span<const SplitItem> items, LeafTriangles& leaf);

    /// Of the leaf just made, each once.
    std::span<const std::uint32_t> vertices() const { return {vertices_.data(), count_}; }

private:
    const TriangleMesh& mesh_;
    /// By vertex: where it was in the last leaf that had it.
    std::vector<std::uint8_t> place_of_;
    std::array<std::uint32_t, 3 * kLeafTriangles> vertices_{};
    std::size_t count_ = 0;
};

/// Fills a new leaf. `corners`: where its vertices are.
void fill_leaf(Bvh8Leaf& leaf, const LeafTriangles& triangles, std::span<const Lanes> vertices);

}  // namespace campuswalk::collision
