#pragma once

#include "engine/script/route_planner.h"
#include "engine/script/walk.h"
#include "engine/simulation/body.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Plans the routes of a simulated body: from its exact state, with its height and the objects that are
/// enabled at that tick.
class BodyRoutes final : public RoutePlanner {
public:
    /// All must outlive it.
    BodyRoutes(const scene::Campus& campus, const SimSettings& sim, const Body& body)
        : campus_(campus), sim_(sim), body_(body) {}

    PlannedRoute plan(const GoToStep& step, double speed) override;

private:
    const scene::Campus& campus_;
    const SimSettings& sim_;
    const Body& body_;
};

}  // namespace campuswalk::engine
