#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/walkspace/walk_space.h"

namespace campuswalk::engine {

/// Ground that one plan can show: hardly any of it lies above other ground of the same storey. The ground,
/// however hilly, the first floors of all buildings, and so on.
struct Storey {
    double low = 1e300;  ///< of its nodes, metres
    double high = -1e300;
    double area = 0.0;         ///< reached, m²
    double main_height = 0.0;  ///< of most of it, to a tenth of a metre
};

struct Storeys {
    std::vector<Storey> list;                         ///< from below
    std::vector<std::vector<std::uint8_t>> of_nodes;  ///< by tile and node: index into `list`

    std::size_t of(const WalkNodeId& node) const { return of_nodes[node.tile][node.node]; }
};

/// What lies less than this above other ground is no storey above it: stairs, furniture. Metres.
inline constexpr double kLeastStoreyHeight = 1.8;

/// A node's storey is how many floors lie below it. Where a level floor lies only partly above others, all of
/// it counts.
Storeys find_storeys(const WalkSpace& space);

}  // namespace campuswalk::engine
