#pragma once

#include <cstddef>
#include <vector>

#include "engine/walkspace/walk_space.h"

namespace campuswalk::engine {

/// A range of heights of a walk space in which hardly any ground lies above other ground: what one plan can
/// show. A storey of a building, or all of a hilly landscape.
struct Storey {
    double low = 0.0;  ///< of its nodes, metres
    double high = 0.0;
    double area = 0.0;  ///< reached, m²
};

/// The storeys from below. A new one begins where ground comes to lie above ground of the storey below; the
/// cut between them is at the height with the least ground.
std::vector<Storey> find_storeys(const WalkSpace& space);

/// The storey that a height belongs to; the nearest if it is between or beyond them. There must be one.
std::size_t storey_at(const std::vector<Storey>& storeys, double y);

}  // namespace campuswalk::engine
