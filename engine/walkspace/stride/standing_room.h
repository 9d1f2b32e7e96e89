#pragma once

#include "collision/mover/mover_settings.h"
#include "collision/world/world.h"
#include "engine/script/mentions.h"

namespace campuswalk::engine {

/// Whether a body that has arrived at the target (has_arrived, `within` metres) may stand there, wherever it
/// came from. False only if it certainly can't: no solid is near enough to carry it, or it would overlap one
/// by over 10 cm at every point of that neighbourhood. True for targets without a height.
bool may_stand_at(const collision::World& world, const collision::QueryFilter& solids,
                  const collision::MoverSettings& body, const Target& target, double within);

}  // namespace campuswalk::engine
