#include "collision/mesh_collider.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <stdexcept>
#include <utility>

#include "collision/wide_tree_check.h"

namespace campuswalk::collision {

namespace {

/// Without a way out in the middle, so that compilers make lanes of it.
std::uint32_t highest_vertex(const TriangleMesh& mesh) {
    std::uint32_t highest = 0;
    for (const auto& t : mesh.triangles) {
        highest = std::max(highest, std::max(t[0], std::max(t[1], t[2])));
    }
    return highest;
}

/// By their bits, for lanes' sake: without its sign a float's bits are in its order, infinity and what is no
/// number above all others.
std::uint32_t largest_coordinate(const TriangleMesh& mesh) {
    constexpr std::uint32_t kNoSign = 0x7FFFFFFF;
    std::uint32_t largest = 0;
    for (const Eigen::Vector3f& p : mesh.positions) {
        for (Eigen::Index k = 0; k < 3; ++k) {
            largest = std::max(largest, std::bit_cast<std::uint32_t>(p[k]) & kNoSign);
        }
    }
    return largest;
}

const TriangleMesh& checked(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) {
        throw std::invalid_argument("a mesh collider needs at least one triangle");
    }
    if (highest_vertex(mesh) >= mesh.positions.size()) {
        throw std::invalid_argument("a triangle names a vertex that is not there");
    }
    const std::uint32_t largest = largest_coordinate(mesh);
    if (largest >= std::bit_cast<std::uint32_t>(std::numeric_limits<float>::infinity())) {
        throw std::invalid_argument("a vertex is not finite");
    }
    if (largest > std::bit_cast<std::uint32_t>(kMaxCoordinate)) {
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

MeshCollider::MeshCollider(TriangleMesh mesh, WideTree tree, ClosedParts closed)
    : MeshCollider(std::move(mesh), std::move(tree)) {
    closed_.emplace(std::move(closed));
}

const ClosedParts& MeshCollider::closed_parts() const {
    std::call_once(closed_once_, [this] {
        if (!closed_) {
            closed_.emplace(mesh_);
        }
    });
    return *closed_;
}

}  // namespace campuswalk::collision
