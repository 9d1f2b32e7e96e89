#pragma once

#include <string>

#include "engine/script/route_planner.h"
#include "engine/script/walk.h"
#include "engine/simulation/body.h"
#include "engine/walkspace/ground_map.h"
#include "engine/walkspace/route.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Plans the routes of a simulated body: from its exact state, with its height and the objects that are
/// enabled at that tick.
class BodyRoutes final : public RoutePlanner {
public:
    /// All must outlive it; `ground` is what RouteSettings::ground is.
    BodyRoutes(const scene::Campus& campus, const SimSettings& sim, const Body& body, GroundMaps* ground)
        : campus_(campus), sim_(sim), body_(body), ground_(ground) {}

    PlannedRoute plan(const GoToStep& step, double speed) override;

    /// Of a body that didn't get straight to the target: how long a route there is, and its first waypoints,
    /// as the end of a failure's message. Empty if there is none, or none that is found soon.
    std::string describe_route_round(const Target& target, double within) const;

private:
    RouteSettings settings(double speed) const;

    const scene::Campus& campus_;
    const SimSettings& sim_;
    const Body& body_;
    GroundMaps* ground_;
};

}  // namespace campuswalk::engine
