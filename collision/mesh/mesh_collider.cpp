#include "collision/mesh/mesh_collider.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "collision/bvh8/bvh8_check.h"
#include "collision/mesh/mesh_extent.h"

namespace campuswalk::collision {

namespace {

const TriangleMesh& checked(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) {
        throw std::invalid_argument("a mesh collider needs at least one triangle");
    }
    if (highest_vertex(mesh.triangles) >= mesh.positions.size()) {
        throw std::invalid_argument("a triangle refers to a vertex that doesn't exist");
    }
    const float largest = largest_coordinate(mesh.positions);
    if (!std::isfinite(largest)) {
        throw std::invalid_argument("a vertex is not finite");
    }
    if (largest > kMaxCoordinate) {
        throw std::invalid_argument("a vertex is out of range");
    }
    return mesh;
}

std::variant<Bvh8, HybridTree> build(const TriangleMesh& mesh, TreeKind tree_kind) {
    if (tree_kind == TreeKind::hybrid) {
        return build_hybrid_tree(mesh);
    }
    return build_bvh8(mesh);
}

}  // namespace

MeshCollider::MeshCollider(TriangleMesh mesh, TreeKind tree_kind, Interior interior)
    : mesh_(std::move(mesh)), tree_(build(checked(mesh_), tree_kind)) {
    if (interior == Interior::found) {
        closed_.emplace(mesh_);
    }
}

MeshCollider::MeshCollider(TriangleMesh mesh, Bvh8 tree, ClosedParts closed)
    : mesh_(std::move(mesh)), tree_(std::move(tree)), closed_(std::move(closed)) {
    checked(mesh_);
    if (const char* fault = fault_of(bvh8(), mesh_.triangles.size())) {
        throw std::invalid_argument(fault);
    }
}

}  // namespace campuswalk::collision
