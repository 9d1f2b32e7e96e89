#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/world/broad_phase.h"
#include "scene/campus/campus.h"

namespace campuswalk::scene {

/// Consecutive triangles of an object's mesh.
struct TriangleRange {
    std::uint32_t first = 0;
    std::uint32_t end = 0;  ///< beyond the last

    bool contains(std::uint32_t triangle) const { return triangle >= first && triangle < end; }
    friend bool operator==(const TriangleRange&, const TriangleRange&) = default;
};

/// Which triangles of an object's collision mesh come from which node: a campus whose walls, doors and
/// furniture are one object can be asked about them one by one.
class NodeTriangles {
public:
    /// Of the objects in the region only; nothing is known of a campus without its models.
    NodeTriangles(const Campus& campus, const collision::Aabb& region);

    /// Those that come from the same node as this one. None for a node that is all of its object, and for
    /// objects that aren't meshes or lie elsewhere.
    std::optional<TriangleRange> of_same_node(collision::ObjectId object, std::uint32_t triangle) const;

private:
    std::vector<std::vector<std::uint32_t>> ends_;  ///< by object, of its nodes' triangles
};

}  // namespace campuswalk::scene
