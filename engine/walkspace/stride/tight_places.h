#pragma once

#include <functional>

#include "collision/mover/mover_settings.h"
#include "collision/world/world.h"

namespace campuswalk::engine {

/// Whether a body with its feet there has less than 0.4 m of room beside it, from half its height upwards:
/// steps, low things and ceilings don't make a place tight. The world, and what `solids` points to, must
/// outlive it. For one thread.
std::function<bool(const collision::Vec3& foot)> tight_places(const collision::World& world,
                                                              const collision::QueryFilter& solids,
                                                              const collision::MoverSettings& body);

}  // namespace campuswalk::engine
