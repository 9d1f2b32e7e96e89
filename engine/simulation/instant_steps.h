#pragma once

#include <optional>

#include "engine/simulation/simulation_state.h"

namespace campuswalk::engine {

/// Executes a step that takes no time, at the end of a tick. Returns the stop if it ends the walk.
std::optional<Stop> execute(const Step& step, SimulationState& state);

}  // namespace campuswalk::engine
