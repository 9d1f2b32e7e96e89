#pragma once

#include <cstdint>
#include <vector>

#include "engine/walkspace/space/walk_space.h"

namespace campuswalk::engine {

/// Ground that some starts lead to, and from which no path leads to what is reached from the others, nor
/// back.
struct SeparateGround {
    std::vector<std::uint32_t> starts;  ///< indices into WalkSpace::starts
    double area = 0.0;                  ///< m², as WalkSpace::area
};

/// All grounds, by their first starts; none if the space is one. Ground that meets with no more than a step
/// of `step_height` metres between is one.
std::vector<SeparateGround> find_separate_grounds(const WalkSpace& space, double step_height);

}  // namespace campuswalk::engine
