#pragma once

#include <optional>

#include "engine/walkspace/barrier/why_not.h"
#include "tools/campuswalk/explore/walk_draft.h"
#include "tools/campuswalk/explore/walk_starts.h"

namespace campuswalk::tools::explore {

/// From ground before the barrier to `goal`, feet, on what isn't reached: straight on, `blocked` until the
/// barrier is away, or where that leads elsewhere by a go_to, `unreachable` until then. None if no such walk
/// shows it.
std::optional<ShownWalk> walk_at_barrier(const engine::Barrier& barrier, const collision::Vec3& goal,
                                         const DraftPlayer& player, WalkStarts& starts);

/// Likewise, but rather by a go_to: for what somebody wants to get to, whichever way there is one day.
std::optional<ShownWalk> walk_to_goal(const engine::Barrier& barrier, const collision::Vec3& goal,
                                      const DraftPlayer& player, WalkStarts& starts);

}  // namespace campuswalk::tools::explore
