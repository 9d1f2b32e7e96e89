#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "collision/base/storage.h"
#include "collision/geometry/fitting.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

// The default tree: up to eight children per node and up to sixteen triangles per leaf, stored side by side
// for vector instructions. Frames and boxes are float32 relative to float32 origins; the slack of queries
// covers that rounding.

inline constexpr std::size_t kBvh8Children = 8;
inline constexpr std::size_t kLeafTriangles = 16;
inline constexpr std::size_t kLeafVertices = 16;

/// Half a unit in the last place of 1 in float32: the greatest rounding of one operation, relative to its
/// result.
inline constexpr float kFloatUnit = 0x1p-24F;

/// The greatest coordinate that a vertex may have, metres: products of three such lengths are still far from
/// overflow.
inline constexpr float kMaxCoordinate = 1e11F;

/// Eight boxes in one frame: y = axes (x - origin), where x is in the mesh's frame. `axes` is a rotation to
/// float32's precision. Unused children have zeros.
///
/// Four cache lines hold all that a ray needs of a node whose frame isn't rotated, as most aren't.
struct alignas(64) Bvh8Node {
    std::array<std::array<float, kBvh8Children>, 3> center{};  ///< of each child's box, by axis
    std::array<std::array<float, kBvh8Children>, 3> half{};    ///< its half extents, rounded outward
    std::array<float, 4> origin{};                             ///< the fourth entry is 0
    float radius = 0.0F;  ///< every vertex, of a box too, is within this distance of the origin
    std::array<std::uint32_t, kBvh8Children> child{};  ///< index of a node or a leaf
    std::uint8_t count = 0;                            ///< number of children
    std::uint8_t leaves = 0;                           ///< bit i: child i is a leaf
    bool rotated = false;                              ///< false: `axes` is the identity
    std::array<float, 3> low{};                        ///< of all the boxes
    std::array<float, 3> high{};
    alignas(64) std::array<std::array<float, 4>, 3> axes{};  ///< by column; the fourth entry is 0
};

static_assert(offsetof(Bvh8Node, rotated) < 256);

/// Triangles that share vertices, and their planes, all relative to one float32 origin, along the mesh's
/// axes.
struct alignas(64) Bvh8Leaf {
    /// By axis, relative to the origin. Unused slots repeat the last vertex.
    std::array<std::array<float, kLeafVertices>, 3> vertex{};
    std::array<std::array<std::uint8_t, kLeafTriangles>, 3>
        vertex_of{};                                       ///< by vertex of a triangle, then triangle
    std::array<float, 4> origin{};                         ///< the fourth entry is 0
    std::array<std::uint32_t, kLeafTriangles> triangle{};  ///< of the mesh, ascending
    float radius = 0.0F;  ///< all vertices are within this distance of the origin
    std::uint8_t vertex_count = 0;
    std::uint8_t triangle_count = 0;
    bool exact = false;             ///< origin + vertex is exactly the mesh's vertex, for all vertices
    std::array<float, 3> facing{};  ///< unit mean normal, or zero
    float low = 0.0F;               ///< least facing . vertex
    float high = 0.0F;              ///< greatest
    /// By component: unit normal n and offset d of n . x = d. Zero for a triangle whose normal isn't certain
    /// to float32's precision, which no plane test separates from anything. Unused slots have a plane that
    /// everything is above.
    alignas(64) std::array<std::array<float, kLeafTriangles>, 4> plane{};
};

/// The same as `vertices(mesh, leaf.triangle[slot])`. Most leaves are exact, which saves a query a distant
/// memory access to the mesh.
inline Triangle vertices(const TriangleMesh& mesh, const Bvh8Leaf& leaf, std::size_t slot) {
    if (!leaf.exact) {
        return vertices(mesh, leaf.triangle[slot]);
    }
    const auto vertex = [&](std::size_t c) {
        const std::size_t at = leaf.vertex_of[c][slot];
        const auto along = [&](std::size_t k) {
            return static_cast<double>(leaf.origin[k]) + static_cast<double>(leaf.vertex[k][at]);
        };
        return Vec3(along(0), along(1), along(2));
    };
    return {vertex(0), vertex(1), vertex(2)};
}

/// Plain data, built by `build_bvh8`. nodes[0] is the root.
struct Bvh8 {
    BoundingSphere outer;  ///< of the whole mesh (paper III.A.1), tested first
    float reach = 0.0F;    ///< greatest coordinate of any vertex
    Storage<Bvh8Node> nodes;
    Storage<Bvh8Leaf> leaves;
};

/// Builds the tree from the top down, by the surface-area heuristic. The mesh must have triangles, and
/// coordinates up to kMaxCoordinate.
Bvh8 build_bvh8(const TriangleMesh& mesh);

}  // namespace campuswalk::collision
