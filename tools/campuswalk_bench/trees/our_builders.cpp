#include "tools/campuswalk_bench/trees/our_builders.h"

#include <span>

namespace campuswalk::tools::bench {

using collision::Bvh8;
using collision::HybridTree;
using collision::MeshCollider;
using collision::TreeKind;
using collision::TriangleMesh;

namespace {

class OurBuilder final : public TreeBuilder {
public:
    OurBuilder(const TriangleMesh& mesh, TreeKind tree_kind) : mesh_(mesh), tree_kind_(tree_kind) {}

    void build() override {
        made_ = std::make_unique<MeshCollider>(mesh_, tree_kind_, collision::Interior::unknown);
    }
    void discard() override { made_.reset(); }

private:
    const TriangleMesh& mesh_;
    TreeKind tree_kind_;
    std::unique_ptr<MeshCollider> made_;
};

template <typename Elements>
std::size_t bytes_in(const Elements& elements) {
    return std::span(elements).size_bytes();
}

std::size_t bytes_of(const Bvh8& tree) {
    return sizeof(tree) + bytes_in(tree.nodes) + bytes_in(tree.leaves);
}

std::size_t bytes_of(const HybridTree& tree) {
    return sizeof(tree) + bytes_in(tree.nodes) + bytes_in(tree.order);
}

}  // namespace

std::unique_ptr<TreeBuilder> make_our_builder(const TriangleMesh& mesh, TreeKind tree_kind) {
    return std::make_unique<OurBuilder>(mesh, tree_kind);
}

std::size_t bytes_of_mesh(const TriangleMesh& mesh) {
    return bytes_in(mesh.positions) + bytes_in(mesh.triangles);
}

std::size_t bytes_of_tree(const MeshCollider& collider) {
    return std::visit([](const auto& tree) { return bytes_of(tree); }, collider.tree());
}

}  // namespace campuswalk::tools::bench
