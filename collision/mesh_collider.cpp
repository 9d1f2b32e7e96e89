#include "collision/mesh_collider.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "collision/wide_tree_check.h"

namespace campuswalk::collision {

namespace {

const TriangleMesh& checked(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) {
        throw std::invalid_argument("a mesh collider needs at least one triangle");
    }
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t v : triangle) {
            if (v >= mesh.positions.size()) {
                throw std::invalid_argument("a triangle names a vertex that is not there");
            }
        }
    }
    if (!std::all_of(mesh.positions.begin(), mesh.positions.end(),
                     [](const auto& p) { return p.allFinite(); })) {
        throw std::invalid_argument("a vertex is not finite");
    }
    if (std::any_of(mesh.positions.begin(), mesh.positions.end(),
                    [](const auto& p) { return p.cwiseAbs().maxCoeff() > kMaxCoordinate; })) {
        throw std::invalid_argument("a vertex is out of range");
    }
    return mesh;
}

std::variant<WideTree, HybridTree> build(const TriangleMesh& mesh, Layout layout) {
    if (layout == Layout::paper) {
        return build_hybrid_tree(mesh);
    }
    return build_wide_tree(mesh);
}

}  // namespace

MeshCollider::MeshCollider(TriangleMesh mesh, Layout layout)
    : mesh_(std::move(mesh)), tree_(build(checked(mesh_), layout)) {}

MeshCollider::MeshCollider(TriangleMesh mesh, WideTree tree)
    : mesh_(std::move(mesh)), tree_(std::move(tree)) {
    checked(mesh_);
    if (const char* fault = fault_of(wide_tree(), mesh_.triangles.size())) {
        throw std::invalid_argument(fault);
    }
}

const ClosedParts& MeshCollider::closed_parts() const {
    std::call_once(closed_once_, [this] { closed_.emplace(mesh_); });
    return *closed_;
}

}  // namespace campuswalk::collision
