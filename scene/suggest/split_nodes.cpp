#include "scene/suggest/split_nodes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "collision/geometry/disjoint_sets.h"
#include "scene/model/connected_pieces.h"
#include "scene/model/name_words.h"
#include "scene/suggest/structures.h"

namespace campuswalk::scene {
namespace {

constexpr std::size_t kMostPieces = 500;

std::vector<Wall> walls_of_piece(const Model& model, const Node& node, const Piece& piece) {
    const Eigen::Matrix3d linear = node.X_world_node.topLeftCorner<3, 3>();
    const Eigen::Vector3d offset = node.X_world_node.topRightCorner<3, 1>();
    std::vector<Wall> walls;
    for (const auto& [m, t] : piece) {
        const Mesh& mesh = model.meshes[index_of(node.meshes[m])];
        std::array<Eigen::Vector3d, 3> vertices;
        for (std::size_t i = 0; i < 3; ++i) {
            vertices[i] = linear * mesh.positions[mesh.triangles[t][i]].cast<double>() + offset;
        }
        if (const std::optional<Wall> wall = wall_of(vertices)) {
            walls.push_back(*wall);
        }
    }
    return walls;
}

/// What the walls enclose on the plan, m².
double footprint_of(const Bounds& walls) {
    const Eigen::Vector3d size = walls.max - walls.min;
    return walls.empty() ? 0.0 : size.x() * size.z();
}

/// Whether the walls are the rim of a floor or of the ground.
bool is_slab(const Bounds& walls) {
    constexpr double kFlat = 0.04;  // of its side
    const Eigen::Vector3d size = walls.max - walls.min;
    return walls.empty() || size.y() < kFlat * std::sqrt(footprint_of(walls));
}

/// Whether the pieces are the rooms or wings of one building rather than houses on a lawn.
bool are_dense(const std::vector<Bounds>& pieces) {
    constexpr double kDense = 0.45;  // of the plan
    Bounds whole;
    double covered = 0.0;
    for (const Bounds& piece : pieces) {
        whole.extend(piece);
        covered += footprint_of(piece);
    }
    return covered >= kDense * footprint_of(whole);
}

/// Pieces whose walls touch are one, as are all that have no walls. None if together they are one building.
std::vector<Piece> joined_by_walls(const Model& model, const Node& node, const std::vector<Piece>& pieces) {
    std::vector<Structure> structures;
    structures.reserve(pieces.size());
    for (const Piece& piece : pieces) {
        std::vector<Wall> walls = walls_of_piece(model, node, piece);
        const WallSum sum = sum_of(walls);
        const bool has_walls = sum.is_built() && !is_slab(sum.bounds);
        structures.push_back({0, has_walls ? std::move(walls) : std::vector<Wall>()});
    }
    collision::DisjointSets sets(pieces.size());
    for (const auto& [a, b] : touching(structures)) {
        sets.join(a, b);
    }
    std::vector<Bounds> walls(pieces.size());
    std::vector<Piece> joined(pieces.size() + 1);  // the last: those without walls
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::size_t root = structures[i].walls.empty() ? pieces.size() : sets.root(i);
        joined[root].insert(joined[root].end(), pieces[i].begin(), pieces[i].end());
        walls[sets.root(i)].extend(sum_of(structures[i].walls).bounds);
    }
    std::erase_if(joined, [](const Piece& piece) { return piece.empty(); });
    return are_dense(walls) ? std::vector<Piece>() : joined;
}

/// The part of a node's meshes that a piece is.
std::vector<Mesh> meshes_of(const Model& model, const Node& node, const Piece& piece) {
    std::map<std::size_t, std::vector<std::size_t>> by_mesh;
    for (const auto& [m, t] : piece) {
        by_mesh[m].push_back(t);
    }
    std::vector<Mesh> meshes;
    for (const auto& [m, triangles] : by_mesh) {
        const Mesh& whole = model.meshes[index_of(node.meshes[m])];
        std::map<std::uint32_t, std::uint32_t> number_of;
        std::vector<Eigen::Vector3f> positions;
        std::vector<std::array<std::uint32_t, 3>> own;
        for (const std::size_t t : triangles) {
            std::array<std::uint32_t, 3> numbers{};
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t vertex = whole.triangles[t][i];
                const auto [known, is_new] =
                    number_of.try_emplace(vertex, static_cast<std::uint32_t>(positions.size()));
                if (is_new) {
                    positions.push_back(whole.positions[vertex]);
                }
                numbers[i] = known->second;
            }
            own.push_back(numbers);
        }
        Mesh& mesh = meshes.emplace_back();
        mesh.positions = std::move(positions);
        mesh.triangles = std::move(own);
        mesh.material = whole.material;
    }
    return meshes;
}

/// None for a node that is one piece.
std::vector<Piece> pieces_of(const Model& model, const Node& node) {
    if (node.meshes.empty() || is_surroundings_name(node.name)) {
        return {};
    }
    std::vector<Piece> pieces = connected_pieces(model, node);
    if (pieces.size() < 2) {
        return {};
    }
    pieces = joined_by_walls(model, node, pieces);
    if (pieces.size() > kMostPieces) {
        std::ranges::stable_sort(pieces, std::greater(), &Piece::size);
        for (std::size_t i = kMostPieces + 1; i < pieces.size(); ++i) {
            pieces[kMostPieces].insert(pieces[kMostPieces].end(), pieces[i].begin(), pieces[i].end());
        }
        pieces.resize(kMostPieces + 1);
    }
    return pieces.size() < 2 ? std::vector<Piece>() : pieces;
}

}  // namespace

SplitModel split_nodes(const Model& model) {
    SplitModel split;
    split.model.file = model.file;
    split.model.materials = model.materials;
    split.model.meshes = model.meshes;
    split.model.geographic = model.geographic;
    std::vector<int> number_of;  // by node of the original
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        const Node& node = model.nodes[n];
        const int own = static_cast<int>(split.model.nodes.size());
        number_of.push_back(own);
        Node copy = node;
        copy.parent = node.parent < 0 ? -1 : number_of[static_cast<std::size_t>(node.parent)];
        const std::vector<Piece> pieces = pieces_of(model, node);
        if (!pieces.empty()) {
            copy.meshes.clear();
        }
        split.model.nodes.push_back(std::move(copy));
        split.node.push_back(n);
        for (const Piece& piece : pieces) {
            Node child;
            child.parent = own;
            child.X_world_node = node.X_world_node;
            for (Mesh& mesh : meshes_of(model, node, piece)) {
                child.meshes.push_back(static_cast<MeshIndex>(split.model.meshes.size()));
                split.model.meshes.push_back(std::move(mesh));
            }
            split.model.nodes.push_back(std::move(child));
            split.node.push_back(n);
        }
    }
    split.report = report_nodes(split.model);
    return split;
}

}  // namespace campuswalk::scene
