#pragma once

#include <vector>

#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Checks before the run what requires the built campus. Returns the diagnostics; without errors the walk can
/// run:
///   spawn-blocked   a spawn or teleport where the avatar's capsule, with its height at that time, doesn't
///                   fit between the objects that are enabled then (see collision::nearest_free_placement)
///   unknown-name    an event that is expected or waited for but can't happen on this campus, whatever the
///                   avatar does; an object or building in an expectation, or an object to enable, disable or
///                   avoid, that doesn't exist
///   spawn-in-air    a spawn over nothing, or more than 0.5 m above what carries the avatar, that doesn't say
///                   `fall: true`
std::vector<scene::Diagnostic> check_walk(const scene::Campus& campus, const Walk& walk);

}  // namespace campuswalk::engine
