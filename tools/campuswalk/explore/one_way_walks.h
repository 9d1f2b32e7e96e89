#pragma once

#include <optional>

#include "engine/walkspace/report/walk_report.h"
#include "tools/campuswalk/explore/walk_draft.h"
#include "tools/campuswalk/explore/walk_starts.h"

namespace campuswalk::tools::explore {

/// From ground before the trap into it and back: `unreachable` until there is a way out, or none in. None if
/// no such walk shows it.
std::optional<ShownWalk> walk_into_trap(const engine::WalkReport& report, const engine::Trap& trap,
                                        const DraftPlayer& player, WalkStarts& starts);

/// From ground before the hole over its edge, for as long as it takes to fall out of the world: `fell` until
/// something is in the way, or below it.
std::optional<ShownWalk> walk_into_hole(const engine::Hole& hole, const DraftPlayer& player,
                                        WalkStarts& starts);

}  // namespace campuswalk::tools::explore
