#pragma once

#include <cstddef>
#include <vector>

#include "scene/lint/model_report.h"
#include "scene/model/model.h"

namespace campuswalk::scene {

/// A model in which a node holds one thing, as far as geometry tells.
struct SplitModel {
    Model model;                     ///< without textures; its pieces have no names
    std::vector<std::size_t> node;   ///< by node: the one of the original model that it is, or is a piece of
    std::vector<NodeReport> report;  ///< by node
};

/// Gives each node whose walls stand apart a child for each piece. Triangles belong together that share a
/// vertex, equal to the bit, or whose walls come closer than about a metre on the plan; what has no upright
/// walls, such as lawns and rocks, is one piece. A node stays whole if its name means surroundings, or if its
/// pieces cover so much of its plan that they are rooms or wings. The 500 pieces with the most triangles
/// stand alone, the others together.
SplitModel split_nodes(const Model& model);

}  // namespace campuswalk::scene
