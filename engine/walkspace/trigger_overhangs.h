#pragma once

#include <vector>

#include "collision/world/world.h"
#include "engine/walkspace/explore.h"
#include "engine/walkspace/storeys.h"
#include "engine/walkspace/walk_space.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// A trigger that reaches through a floor: made for one storey, it is also entered from another, by the head
/// or the feet only.
struct TriggerOverhang {
    collision::ObjectId trigger{};
    std::size_t storey = 0;  ///< that it wasn't made for
    collision::Vec3 foot;    ///< where one stands in it there
    bool from_above = true;  ///< it is the head that is in it, not the feet
    double depth = 0.0;      ///< how much of the body's height its bounds reach into, metres
    /// Other triggers that the body's middle is in at that place, ascending.
    std::vector<collision::ObjectId> also_in = {};
};

/// Each trigger and storey, in the order of objects. A trigger is made for the storeys where the body's
/// middle gets into it, and for those at whose bodies its own middle is: one that fills a whole building is
/// made for all of them.
std::vector<TriggerOverhang> find_trigger_overhangs(const scene::Campus& campus, const WorkerWorlds& worlds,
                                                    const ExploreSettings& settings, const WalkSpace& space,
                                                    const Storeys& storeys);

}  // namespace campuswalk::engine
