#pragma once

#include <optional>

#include "engine/events/reason.h"
#include "engine/script/route.h"
#include "engine/script/step.h"

namespace campuswalk::engine {

/// What came of planning a step's route.
struct PlannedRoute {
    Route route;
    std::optional<Reason> why_not = {};  ///< there is none, or none was found, and this is why
};

/// Where a script's player gets its routes from: what knows where exactly the avatar is, its body and the
/// objects that are enabled now.
class RoutePlanner {
public:
    virtual ~RoutePlanner() = default;

    /// From where the avatar is, at `speed` metres per second.
    virtual PlannedRoute plan(const GoToStep& step, double speed) = 0;
};

}  // namespace campuswalk::engine
