#pragma once

#include <cstddef>
#include <vector>

#include "scene/model/model.h"

namespace campuswalk::scene {

/// A triangle of a node: which of its meshes, and which of that mesh's triangles.
struct TriangleRef {
    std::size_t mesh = 0;
    std::size_t triangle = 0;
};

using Piece = std::vector<TriangleRef>;

/// The triangles of a node by the vertices that they share, equal to the bit.
std::vector<Piece> connected_pieces(const Model& model, const Node& node);

}  // namespace campuswalk::scene
