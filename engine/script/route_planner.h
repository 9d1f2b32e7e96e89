#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "engine/script/route.h"
#include "engine/script/step.h"

namespace campuswalk::engine {

/// What came of planning a step's route.
struct PlannedRoute {
    Route route;
    std::string why_not;                         ///< there is none, and this is why; empty: there is one
    std::optional<Eigen::Vector3d> why_at = {};  ///< where that was found
    bool incomplete = false;                     ///< none was found, but not everything was searched
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
