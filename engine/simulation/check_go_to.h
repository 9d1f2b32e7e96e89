#pragma once

#include <vector>

#include "engine/script/walk.h"
#include "engine/simulation/route_memory.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Warns of the steps go_to that can't get to their places, with the measured reason:
///   unreachable-place   the walk would end there with the failure `unreachable`
/// Plays the walk up to its last go_to, without what doesn't move the avatar, so that each is asked about
/// from where the avatar is then, with its height and the objects that are enabled. Where one can't be
/// reached, the avatar stays and goes on with the next step. Those after a step that ends the walk otherwise
/// aren't checked, nor are the walks that must fail so. `memory` may be null.
std::vector<scene::Diagnostic> check_go_to(const scene::Campus& campus, const Walk& walk,
                                           RouteMemory* memory);

}  // namespace campuswalk::engine
