#pragma once

#include <cstddef>
#include <cstdint>

#include "collision/base/storage.h"
#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

/// The parts of a mesh that enclose a volume: connected, with no open edge, facing outward. Terrain, single
/// walls and rooms that are modelled from within have none, so nothing is "inside" them.
class ClosedParts {
public:
    /// Vertices at the same float32 position count as one vertex, whatever their indices.
    explicit ClosedParts(const TriangleMesh& mesh);
    /// What `members` and `bounds` gave before, as from a file. Throws std::invalid_argument when they aren't
    /// those of a mesh of so many triangles.
    ClosedParts(Storage<std::uint64_t> members, const Aabb& bounds, std::size_t mesh_triangles);

    bool empty() const { return members_.empty(); }
    /// Whether the mesh's triangle belongs to one. Ask only when there are parts.
    bool has(std::size_t triangle) const { return (members_[triangle / 64] >> triangle % 64 & 1U) != 0; }
    /// Of all of them together.
    const Aabb& bounds() const { return bounds_; }
    /// A bit a triangle, from the lowest of the first word on; none without parts.
    const Storage<std::uint64_t>& members() const { return members_; }

private:
    Storage<std::uint64_t> members_;
    Aabb bounds_;
};

}  // namespace campuswalk::collision
