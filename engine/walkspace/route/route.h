#pragma once

#include <cstddef>
#include <functional>
#include <variant>
#include <vector>

#include "collision/mover/mover.h"
#include "collision/world/world.h"
#include "engine/script/route.h"
#include "engine/script/step.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/route/ground_map.h"
#include "engine/walkspace/space/walk_space.h"

namespace campuswalk::engine {

/// Whose routes, and among what.
struct RouteSettings {
    StrideSettings strides;         ///< its walk_speed is the speed
    collision::QueryFilter solids;  ///< what it points to must outlive the call
    /// Where the body must not be, by its feet. May be empty.
    std::function<bool(const collision::Vec3& foot)> keep_out = {};
    /// What that is about, for messages.
    std::vector<Avoided> avoided = {};
    /// Where it had rather not be: a way through such places counts kTightFactor times. May be empty.
    std::function<bool(const collision::Vec3& foot)> is_tight = {};
    std::size_t max_nodes = 60'000'000;
    /// What earlier routes found of the ground: saves time and changes no route. May be null; else it must
    /// outlive the call, and no other thread may use it.
    GroundMaps* ground = nullptr;
};

struct RouteRequest {
    collision::MoverState from;  ///< exactly
    std::vector<Target> to;      ///< at least one; passed in their order, the last is the goal
    double within = 0.05;        ///< metres, horizontal, of the last
};

/// There is no route.
struct NoRoute {
    Target target;  ///< the first that isn't reached
    /// All that is reached from the target before it, with its rim. Empty if the body doesn't come to stand.
    WalkSpace reached;
    bool incomplete = false;  ///< the most nodes were explored, and there is more
    bool no_room = false;     ///< nothing was explored: nobody can stand at the target (may_stand_at)
};

/// Straight on where that leads there. Else along a path that is guessed from the geometry, and only where
/// that can't be walked along a chain of strides through the walk space, explored no farther than it must be;
/// pulled straight wherever a trial walk arrives. Each piece was walked from the very state in which the one
/// before ended, so that the avatar's steps can't fail. Depends on its arguments alone, and not on what
/// `ground` knows.
std::variant<Route, NoRoute> plan_route(const collision::World& world, const RouteSettings& settings,
                                        const RouteRequest& request);

}  // namespace campuswalk::engine
