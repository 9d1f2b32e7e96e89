#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/lint/model_report.h"

namespace campuswalk::tools {

/// A line of the list of nodes: one node, or four or more siblings whose names differ only in numbers, with
/// all below them.
struct NodeLine {
    std::string name;  ///< `tree_*` for several
    int depth = 0;     ///< 0 at the root
    std::size_t nodes = 1;
    std::size_t triangles = 0;                       ///< of all of them, with what isn't listed below them
    Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< metres, of the largest
    std::vector<std::size_t> materials;              ///< indices into ModelReport::materials, ascending
};

struct NodeList {
    std::vector<NodeLine> lines;    ///< parents before their children
    std::size_t omitted_nodes = 0;  ///< in no line: those deepest down, and of those the smallest
};

/// No more than `max_lines`.
NodeList list_nodes(const std::vector<scene::NodeReport>& nodes, std::size_t max_lines);

}  // namespace campuswalk::tools
