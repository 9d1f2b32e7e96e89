#include "scene/model/connected_pieces.h"

#include <cstdint>
#include <map>
#include <utility>

#include "collision/geometry/disjoint_sets.h"
#include "scene/model/weld.h"

namespace campuswalk::scene {

std::vector<Piece> connected_pieces(const Model& model, const Node& node) {
    std::size_t vertices = 0;
    for (const MeshIndex index : node.meshes) {
        vertices += model.meshes[index_of(index)].positions.size();
    }
    WeldTable<3> welded(vertices);
    std::vector<std::vector<std::uint32_t>> numbers;  // by mesh and vertex
    for (const MeshIndex index : node.meshes) {
        std::vector<std::uint32_t>& own = numbers.emplace_back();
        for (const Eigen::Vector3f& p : model.meshes[index_of(index)].positions) {
            own.push_back(welded.number_of(bits_of(p)));
        }
    }
    collision::DisjointSets sets(welded.size());
    for (std::size_t m = 0; m < node.meshes.size(); ++m) {
        for (const auto& [a, b, c] : model.meshes[index_of(node.meshes[m])].triangles) {
            sets.join(numbers[m][a], numbers[m][b]);
            sets.join(numbers[m][b], numbers[m][c]);
        }
    }
    std::map<std::uint32_t, Piece> by_root;
    for (std::size_t m = 0; m < node.meshes.size(); ++m) {
        const auto& triangles = model.meshes[index_of(node.meshes[m])].triangles;
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            by_root[sets.root(numbers[m][triangles[t][0]])].push_back({m, t});
        }
    }
    std::vector<Piece> pieces;
    for (auto& [root, piece] : by_root) {
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

}  // namespace campuswalk::scene
