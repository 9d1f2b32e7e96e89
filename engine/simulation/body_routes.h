#pragma once

#include <optional>

#include "engine/events/reason.h"
#include "engine/script/route_planner.h"
#include "engine/script/walk.h"
#include "engine/simulation/body.h"
#include "engine/simulation/route_memory.h"
#include "engine/walkspace/route/route.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Plans the routes of a simulated body: from its exact state, with its height and the objects that are
/// enabled at that tick.
class BodyRoutes final : public RoutePlanner {
public:
    /// All must outlive it; `memory` may be null.
    BodyRoutes(const scene::Campus& campus, const SimSettings& sim, const Body& body, RouteMemory* memory)
        : campus_(campus), sim_(sim), body_(body), memory_(memory) {}

    PlannedRoute plan(const GoToStep& step, double speed) override;

    /// For a body that didn't get straight to the target. None if no route leads there, or none that is found
    /// soon.
    std::optional<RouteHint> route_round(const Target& target, double within) const;
    /// Likewise for a body that left the ground at `foot`.
    std::optional<RouteHint> route_round(const Target& target, double within,
                                         const Eigen::Vector3d& foot) const;

private:
    PlannedRoute plan_anew(const GoToStep& step, RouteSettings settings) const;
    RouteSettings settings(double speed) const;
    std::optional<RouteHint> route_hint(const collision::MoverState& from, const Target& target,
                                        double within) const;

    const scene::Campus& campus_;
    const SimSettings& sim_;
    const Body& body_;
    RouteMemory* memory_;
};

}  // namespace campuswalk::engine
