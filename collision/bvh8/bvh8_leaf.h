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

/// A leaf's triangles, with indices of the leaf's vertices.
struct LeafTriangles {
    std::array<std::uint32_t, kLeafTriangles> triangle{};
    std::array<std::array<std::uint8_t, kLeafTriangles>, 3>
        vertex_of{};  ///< by vertex of a triangle, then triangle
    std::uint8_t triangle_count = 0;
    std::uint8_t vertex_count = 0;
};

/// Puts triangles into leaves, one leaf after the other.
class LeafMaker {
public:
    explicit LeafMaker(const TriangleMesh& mesh) : mesh_(mesh), slot_of_(mesh.positions.size()) {}

    /// False if there are too many triangles or vertices for a leaf.
    bool make(std::span<const SplitItem> items, LeafTriangles& leaf);

    /// The vertices of the leaf just made, each once, as indices of the mesh.
    std::span<const std::uint32_t> vertices() const { return {vertices_.data(), count_}; }

private:
    const TriangleMesh& mesh_;
    /// By vertex: its slot in the last leaf that had it.
    std::vector<std::uint8_t> slot_of_;
    std::array<std::uint32_t, 3 * kLeafTriangles> vertices_{};
    std::size_t count_ = 0;
};

/// Fills a new leaf. `vertices` are the positions of its vertices.
void fill_leaf(Bvh8Leaf& leaf, const LeafTriangles& triangles, std::span<const Lanes> vertices);

}  // namespace campuswalk::collision
