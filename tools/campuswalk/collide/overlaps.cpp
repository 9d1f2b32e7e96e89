#include "tools/campuswalk/collide/overlaps.h"

#include <algorithm>
#include <memory>
#include <variant>

#include "collision/geometry/convex_distance.h"
#include "collision/mesh/mesh_contacts.h"
#include "collision/mesh/mesh_query.h"

namespace campuswalk::tools::collide {

using collision::Box;
using collision::Capsule;
using collision::MeshCollider;
using collision::Pose;
using collision::Sphere;
using collision::TrianglePair;
using collision::Vec3;
using collision::Wheel;

namespace {

using Mesh = std::shared_ptr<const MeshCollider>;

// The triangles of a mesh that a solid overlaps, in the mesh's frame.

void triangles_of(const MeshCollider& mesh, const Sphere& sphere, const Pose& X,
                  std::vector<std::uint32_t>& out) {
    triangles_near(mesh, {X.translation, X.translation}, sphere.radius, out);
}

void triangles_of(const MeshCollider& mesh, const Capsule& capsule, const Pose& X,
                  std::vector<std::uint32_t>& out) {
    const Vec3 half = X.rotate(Vec3(0.0, capsule.half_length, 0.0));
    triangles_near(mesh, {X.translation - half, X.translation + half}, capsule.radius, out);
}

void triangles_of(const MeshCollider& mesh, const Box& box, const Pose& X, std::vector<std::uint32_t>& out) {
    triangles_in_box(mesh, box, X, out);
}

void triangles_of(const MeshCollider& mesh, const Wheel& wheel, const Pose& X,
                  std::vector<std::uint32_t>& out) {
    constexpr double kRoomForRounding = 1.0 + 1e-9;  // the box only gathers candidates
    const Vec3 half = kRoomForRounding * Vec3(wheel.half_width, wheel.radius, wheel.radius);
    triangles_of(mesh, Box{half}, X, out);
    const collision::ConvexSolid solid = convex_solid(wheel, X);
    std::erase_if(out,
                  [&](std::uint32_t t) { return distance_between(solid, vertices(mesh.mesh(), t)) > 0.0; });
}

/// Handles every combination of mesh and solid. X_a_b_ relates their own frames: a mesh's starts at its
/// origin.
class Search {
public:
    Search(const Body& a, const Body& b, const Pose& X_a_b, SearchMode mode) : mode_(mode) {
        X_a_b_.rotation = X_a_b.rotation;
        X_a_b_.translation = X_a_b * b.p_body_mesh - a.p_body_mesh;
    }

    Overlaps operator()(const Mesh& a, const Mesh& b) const {
        Overlaps overlaps;
        if (mode_ == SearchMode::all) {
            all_contacts(*a, *b, X_a_b_, overlaps.pairs);
            std::ranges::sort(overlaps.pairs);
        } else if (const std::optional<TrianglePair> pair = first_contact(*a, *b, X_a_b_)) {
            overlaps.pairs.push_back(*pair);
        }
        overlaps.any = !overlaps.pairs.empty();
        return overlaps;
    }

    template <typename Solid>
    Overlaps operator()(const Mesh& a, const Solid& b) const {
        return triangles(*a, b, X_a_b_);
    }

    template <typename Solid>
    Overlaps operator()(const Solid& a, const Mesh& b) const {
        Pose X_b_a;
        X_b_a.rotation = X_a_b_.rotation.transpose();
        X_b_a.translation = -X_a_b_.inverse_rotate(X_a_b_.translation);
        return triangles(*b, a, X_b_a);
    }

    template <typename SolidA, typename SolidB>
    Overlaps operator()(const SolidA& a, const SolidB& b) const {
        Overlaps overlaps;
        overlaps.distance = distance_between(convex_solid(a, Pose{}), convex_solid(b, X_a_b_));
        overlaps.any = *overlaps.distance <= 0.0;
        return overlaps;
    }

private:
    template <typename Solid>
    Overlaps triangles(const MeshCollider& mesh, const Solid& solid, const Pose& X_mesh_solid) const {
        Overlaps overlaps;
        triangles_of(mesh, solid, X_mesh_solid, overlaps.triangles);
        overlaps.any = !overlaps.triangles.empty();
        if (mode_ == SearchMode::first && overlaps.any) {
            overlaps.triangles.resize(1);
        }
        return overlaps;
    }

    Pose X_a_b_;
    SearchMode mode_;
};

}  // namespace

std::size_t Overlaps::count() const {
    return distance ? (any ? 1 : 0) : pairs.size() + triangles.size();
}

Overlaps find_overlaps(const Body& a, const Body& b, const Pose& X_a_b, SearchMode mode) {
    return std::visit(Search(a, b, X_a_b, mode), a.shape, b.shape);
}

}  // namespace campuswalk::tools::collide
