#pragma once

#include <memory>

#include "collision/world/world.h"

namespace campuswalk::support {

/// Half the side of the village's ground, metres.
constexpr double kVillageHalf = 20.0;

/// A small place with something of everything: uneven ground, rooms with doors, a single-sided garden wall,
/// stairs, a ramp, wedge-shaped corners, trees, benches, a fountain, a ball, lying logs.
/// (0, 1, 0) is free and some way above the ground.
std::unique_ptr<collision::World> make_village();

}  // namespace campuswalk::support
