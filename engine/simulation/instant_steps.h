#pragma once

#include <optional>

#include "engine/script/walk.h"
#include "engine/simulation/simulation_state.h"

namespace campuswalk::engine {

/// Carries out a step that takes no time, at the end of a tick. The stop, if the walk ends with it.
std::optional<Stop> carry_out(const Step& step, SimulationState& state);

}  // namespace campuswalk::engine
