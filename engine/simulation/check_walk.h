#pragma once

#include <vector>

#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Checks what needs the built campus, before anything runs. Returns the diagnostics, empty when the walk can
/// run:
///   spawn-blocked   a spawn or teleport where the avatar's capsule, as tall as it is by then, doesn't fit
///                   between what isn't disabled by then (see collision::nearest_free_placement)
///   unknown-name    an event that is expected or waited for and can't happen on this campus, whatever the
///                   avatar does; an object or building in an expectation, or an object to enable or disable,
///                   that isn't there
std::vector<scene::Diagnostic> check_walk(const scene::Campus& campus, const Walk& walk);

}  // namespace campuswalk::engine
