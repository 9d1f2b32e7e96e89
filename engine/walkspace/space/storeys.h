#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/walkspace/space/walk_space.h"

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

/// The reached node that is nearest to a point: below it if there is one within so many metres to the side,
/// seen from above.
std::optional<WalkNodeId> node_near(const WalkSpace& space, const collision::Vec3& at, double around);
/// The storey of the ground that is reached there or near it; without any, of what is as high. There must be
/// one.
std::size_t storey_near(const WalkSpace& space, const Storeys& storeys, const collision::Vec3& at);
/// Of the storeys whose range has this height, that with most of its ground near it.
std::size_t storey_at_height(const Storeys& storeys, double y);

/// A node's storey is how many floors lie below it. Where a level floor lies only partly above others, all of
/// it counts.
Storeys find_storeys(const WalkSpace& space);

}  // namespace campuswalk::engine
