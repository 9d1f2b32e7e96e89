#pragma once

#include <optional>

#include "engine/script/walk.h"

namespace campuswalk::engine {

/// Simulated seconds that the walk's steps take where nothing is in the way and the ground is level; none for
/// a walk that waits for an event.
std::optional<double> planned_seconds(const Walk& walk);

}  // namespace campuswalk::engine
