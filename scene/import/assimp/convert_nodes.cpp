#include "scene/import/assimp/convert_nodes.h"

#include <assimp/scene.h>

namespace campuswalk::scene {
namespace {

Eigen::Matrix4d to_matrix(const aiMatrix4x4& m) {
    Eigen::Matrix4d result;
    for (unsigned int row = 0; row < 4; ++row) {
        for (unsigned int column = 0; column < 4; ++column) {
            result(row, column) = static_cast<double>(m[row][column]);
        }
    }
    return result;
}

struct Visit {
    const aiNode* node = nullptr;
    int parent = -1;
};

}  // namespace

NodeTree convert_nodes(const aiNode& root, const Eigen::Matrix4d& X_world_file) {
    NodeTree tree;
    std::vector<Visit> pending = {{&root, -1}};
    while (!pending.empty()) {
        const Visit visit = pending.back();
        pending.pop_back();
        const Eigen::Matrix4d X_world_parent =
            visit.parent < 0 ? X_world_file : tree.nodes[static_cast<std::size_t>(visit.parent)].X_world_node;
        const int self = static_cast<int>(tree.nodes.size());
        Node node;
        node.name = visit.node->mName.C_Str();
        node.parent = visit.parent;
        node.X_world_node = X_world_parent * to_matrix(visit.node->mTransformation);
        node.X_world_node.bottomRows<1>() << 0, 0, 0, 1;  // whatever the file says: it is affine
        tree.nodes.push_back(std::move(node));
        tree.mesh_numbers.emplace_back(visit.node->mMeshes, visit.node->mMeshes + visit.node->mNumMeshes);
        for (unsigned int i = visit.node->mNumChildren; i > 0;
             --i) {  // last first: the stack turns them round
            pending.push_back({visit.node->mChildren[i - 1], self});
        }
    }
    return tree;
}

}  // namespace campuswalk::scene
