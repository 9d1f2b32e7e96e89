#pragma once

#include <cstddef>
#include <vector>

#include "collision/shapes.h"
#include "collision/triangle_mesh.h"

namespace campuswalk::collision {

/// The parts of a mesh that enclose a volume: connected, with no open edge, facing outward. Terrain, single
/// walls and rooms that are modelled from within have none, so nothing is "inside" them.
class ClosedParts {
public:
    /// Corners at the same float32 position count as one vertex, whatever their indices.
    explicit ClosedParts(const TriangleMesh& mesh);

    bool empty() const { return members_.empty(); }
    /// Whether the mesh's triangle belongs to one. Ask only when there are parts.
    bool has(std::size_t triangle) const { return members_[triangle]; }
    /// Of all of them together.
    const Aabb& bounds() const { return bounds_; }

private:
    std::vector<bool> members_;  ///< by triangle; none without parts
    Aabb bounds_;
};

}  // namespace campuswalk::collision
