#pragma once

#include <vector>

#include "engine/script/walk.h"
#include "scene/campus.h"

namespace campuswalk::engine {

/// Checks what needs the built campus, before anything runs. Returns the complaints, empty when the walk can
/// run:
///   spawn-blocked   a spawn or teleport where the avatar's capsule doesn't fit
///   unknown-name    an expected event that can't happen on this campus, whatever the avatar does
std::vector<scene::Diagnostic> check_walk(const scene::Campus& campus, const Walk& walk);

}  // namespace campuswalk::engine
