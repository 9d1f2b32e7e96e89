#pragma once

#include <vector>

#include "collision/mover/mover_settings.h"
#include "engine/walkspace/barrier/why_not.h"

namespace campuswalk::engine {

/// One ability of a body, and how it could be better.
struct Ability {
    BarrierKind kind;            ///< of what it overcomes
    double have;                 ///< metres or radians, as Barrier::allowed
    std::vector<double> easier;  ///< values that make it easier, step by step
    double precision;            ///< that the value which is needed is measured with
    void (*apply)(double value, collision::MoverSettings& body);
};

/// Step, slope, width and height, without those that can't be better.
std::vector<Ability> abilities_of(const collision::MoverSettings& body);

}  // namespace campuswalk::engine
