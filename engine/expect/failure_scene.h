#pragma once

#include "engine/expect/failure.h"
#include "engine/expect/state_snapshot.h"
#include "engine/script/avatar.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// What there is to tell of a moment: where the avatar was, which solid object was nearest to its body (the
/// ground that it stood on aside, no farther than 10 m), which building, and what had happened last.
FailureScene scene_of(const StateSnapshot& moment, const scene::Campus& campus, const AvatarProfile& avatar);

}  // namespace campuswalk::engine
