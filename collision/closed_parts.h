#pragma once

#include <cstdint>
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

    bool empty() const { return triangles_.empty(); }

    /// Is `point` (mesh frame) inside a part? By the winding number along one fixed direction.
    bool contains(const Vec3& point) const;

private:
    std::vector<Triangle> triangles_;
};

}  // namespace campuswalk::collision
