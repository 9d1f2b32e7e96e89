#pragma once

#include "engine/expect/failure.h"
#include "engine/expect/state_snapshot.h"
#include "engine/script/avatar.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// What a failure report says about a state: where the avatar was, the solid object nearest to its body (at
/// most 10 m away, and not the ground that it stood on) and where that is nearly touched, the building, and
/// the last events.
FailureScene scene_of(const StateSnapshot& state, const scene::Campus& campus, const AvatarProfile& avatar);

/// Adds what blocked the avatar last, as far as the failure says nothing of its own about that.
void add_obstacle(const StateSnapshot& state, Failure& failure);

}  // namespace campuswalk::engine
