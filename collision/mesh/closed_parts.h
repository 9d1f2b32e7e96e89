#pragma once

#include <cstddef>
#include <cstdint>

#include "collision/base/storage.h"
#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

/// The parts of a mesh that enclose a volume: connected, without open edges, facing outward. Terrain, single
/// walls and rooms that are modelled from the inside have none, so nothing is "inside" them.
class ClosedParts {
public:
    /// Vertices at the same float32 position count as one vertex, whatever their indices.
    explicit ClosedParts(const TriangleMesh& mesh);
    /// From earlier results of `members` and `bounds`, such as one read from a file. Throws
    /// std::invalid_argument if they don't fit a mesh with so many triangles.
    ClosedParts(Storage<std::uint64_t> members, const Aabb& bounds, std::size_t mesh_triangles);

    bool empty() const { return members_.empty(); }
    /// Whether the triangle belongs to a closed part. There must be parts.
    bool has(std::size_t triangle) const { return (members_[triangle / 64] >> triangle % 64 & 1U) != 0; }
    /// Of all parts together.
    const Aabb& bounds() const { return bounds_; }
    /// One bit per triangle, from the lowest bit of the first word; empty without parts.
    const Storage<std::uint64_t>& members() const { return members_; }

private:
    Storage<std::uint64_t> members_;
    Aabb bounds_;
};

}  // namespace campuswalk::collision
