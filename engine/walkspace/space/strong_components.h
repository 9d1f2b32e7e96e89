#pragma once

#include <cstdint>
#include <vector>

namespace campuswalk::engine {

/// Of a directed graph, given as the targets of each vertex's edges: for each vertex the least vertex of its
/// strongly connected component, those that one gets to from it and back from. In time linear in vertices and
/// edges (Kosaraju and Sharir; Aho, Hopcroft and Ullman, "Data Structures and Algorithms", section 6.7).
std::vector<std::uint32_t> strong_components(const std::vector<std::vector<std::uint32_t>>& targets);

}  // namespace campuswalk::engine
