#pragma once

#include <vector>

#include "collision/mover/mover_settings.h"
#include "engine/walkspace/barrier/why_not.h"

namespace campuswalk::engine {

/// One ability of a body, and how it could be better.
struct Ability {
    ReasonKind kind;             ///< of what it overcomes
    double have;                 ///< metres or radians, as Barrier::allowed
    std::vector<double> easier;  ///< values that make it easier, step by step
    double precision;            ///< that the value which is needed is measured with
    void (*apply)(double value, collision::MoverSettings& body);
};

/// Step, slope, width and height, without those that can't be better.
std::vector<Ability> abilities_of(const collision::MoverSettings& body);
/// Only steps up to kHighestRiser, and slopes.
std::vector<Ability> climbs_of(const collision::MoverSettings& body);
/// Only width and height.
std::vector<Ability> sizes_of(const collision::MoverSettings& body);
bool is_about_size(const Ability& ability);

/// The body with these abilities as good as can be.
collision::MoverSettings easiest_of(collision::MoverSettings body, const std::vector<Ability>& abilities);

}  // namespace campuswalk::engine
