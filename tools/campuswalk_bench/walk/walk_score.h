#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::tools::bench {

/// Says whether a walker is in a mesh or went through it, from the raw triangles in columns of a grid and by
/// the plainest formulas: it shares no function with what it judges.
class WalkEvaluator {
public:
    /// The mesh must outlive it.
    explicit WalkEvaluator(const collision::TriangleMesh& mesh);

    /// How deep an upright capsule is in the triangle that it is in deepest, metres; 0 if it is in none.
    double penetration(const collision::Vec3& foot, double radius, double height) const;

    /// Whether a point that goes straight from one place to the other meets a triangle.
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
    std::size_t side_ = 1;              ///< columns
    double width_ = 1.0;                ///< metres a column
    std::vector<std::uint32_t> first_;  ///< by column, into triangles_
    std::vector<std::uint32_t> triangles_;
};

}  // namespace campuswalk::tools::bench
