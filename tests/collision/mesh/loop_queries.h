#pragma once

#include <array>
#include <vector>

#include "collision/mesh/mesh_query.h"
#include "tests/support/dice.h"

/// The queries of mesh_query.h as loops over all triangles, and meshes for testing both trees.
namespace campuswalk::collision {

std::vector<std::uint32_t> loop_near(const TriangleMesh& mesh, const Segment& segment, double radius);
std::vector<MeshHit> loop_all_on_ray(const TriangleMesh& mesh, const Ray& ray);
std::vector<std::uint32_t> loop_in_box(const TriangleMesh& mesh, const Box& box, const Pose& X_mesh_box);
MeshPoint loop_closest_point(const TriangleMesh& mesh, const Vec3& point);
std::optional<MeshHit> loop_sweep(const TriangleMesh& mesh, const Segment& segment, double radius,
                                  const Vec3& move);

/// Those that this machine supports, the smallest first.
std::vector<SimdTarget> supported_simd_targets();

/// One mesh with both trees.
struct BothTrees {
    MeshCollider bvh8;
    MeshCollider hybrid;

    explicit BothTrees(const TriangleMesh& mesh) : bvh8(mesh), hybrid(mesh, TreeKind::hybrid) {}
    const TriangleMesh& mesh() const { return bvh8.mesh(); }
    std::array<const MeshCollider*, 2> each() const { return {&bvh8, &hybrid}; }
};

/// A mesh that is easy or hard for a tree: scattered, regular, all in one place or a single triangle.
TriangleMesh mesh_of_some_kind(support::Dice& dice);
/// A lattice, at the mesh's origin or 450 km from it; needles; or triangles without area, each several times.
TriangleMesh hard_mesh(support::Dice& dice);
/// A point within `reach` of one of the mesh, along each axis.
Vec3 point_around(const TriangleMesh& mesh, support::Dice& dice, double reach);

}  // namespace campuswalk::collision
