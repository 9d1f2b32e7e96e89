#pragma once

#include <vector>

#include "collision/world/world.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/space/storeys.h"
#include "engine/walkspace/space/walk_space.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// A trigger that reaches through a floor: made for one storey, it is also entered from another, by the head
/// or the feet only.
struct TriggerOverhang {
    collision::ObjectId trigger{};
    std::size_t storey = 0;  ///< of the ground that it wasn't made for
    collision::Vec3 foot;    ///< where one stands in it there
    bool from_above = true;  ///< it is the head that is in it, not the feet
    double depth = 0.0;      ///< how much of the body's height its bounds reach into, metres
    /// Other triggers that the body's middle is in at that place, ascending.
    std::vector<collision::ObjectId> also_in = {};
};

/// Each trigger and storey, in the order of objects. Who stands in a room stands wholly in a trigger that
/// fills it, whatever its height. So a trigger is made for where the body is in it from feet to head, and for
/// what one gets to from there without leaving it, such as the stairs of which it has only the lower ones.
/// One that no body is wholly in is made for where most of a body is. It is an overhang on ground with less
/// of the body in it, if that is on a storey that it isn't made for, or above or below ground with more of
/// the body in it.
std::vector<TriggerOverhang> find_trigger_overhangs(const scene::Campus& campus, const WorkerWorlds& worlds,
                                                    const ExploreSettings& settings, const WalkSpace& space,
                                                    const Storeys& storeys);

}  // namespace campuswalk::engine
