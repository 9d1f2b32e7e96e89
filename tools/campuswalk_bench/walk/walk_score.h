#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::tools::bench {

/// Measures how deep a walker is in a mesh and whether it passed through it, with simple formulas on the raw
/// triangles in the columns of a grid: it shares no function with the movers that it scores.
class WalkScorer {
public:
    /// The mesh must outlive the scorer.
    explicit WalkScorer(const collision::TriangleMesh& mesh);

    /// The greatest depth of an upright capsule in a triangle, metres; 0 if it overlaps none.
    double penetration(const collision::Vec3& foot, double radius, double height) const;

    /// Whether the segment between the points crosses a triangle.
    bool crosses(const collision::Vec3& from, const collision::Vec3& to) const;

private:
    struct Columns {
        std::size_t low_x = 0;
        std::size_t high_x = 0;
        std::size_t low_z = 0;
        std::size_t high_z = 0;
    };

    Columns columns_of(const collision::Aabb& box) const;
    template <typename Visit>
    void visit_near(const collision::Aabb& box, const Visit& visit) const;

    const collision::TriangleMesh& mesh_;
    collision::Vec3 low_ = collision::Vec3::Zero();
    std::size_t side_ = 1;              ///< columns per side
    double width_ = 1.0;                ///< metres per column
    std::vector<std::uint32_t> first_;  ///< by column, into triangles_
    std::vector<std::uint32_t> triangles_;
};

}  // namespace campuswalk::tools::bench
