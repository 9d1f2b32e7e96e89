#include "engine/simulation/spawn_fall.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "collision/mover/mover_settings.h"
#include "engine/simulation/body.h"

namespace campuswalk::engine {

SpawnFall fall_at_spawn(const scene::Campus& campus, const Walk& walk) {
    const auto& spawn = std::get<SpawnStep>(walk.steps.front());
    const std::vector<bool> disabled(campus.objects.size(), false);
    collision::QueryStatistics statistics;
    Body body(campus, walk, disabled);
    Intent intent;
    intent.placement = {&spawn.label, spawn.position, EventKind::avatar_spawn};
    body.follow(intent, statistics);
    const double start = spawn.position.y();  // the first tick may already end on the ground
    intent.placement.reset();
    // Twice the time of a free fall to the abyss: a body that slides down a slope takes longer than one that
    // falls, and one that is held on its way never gets there.
    const double depth = std::max(0.0, start - campus.world.bounds().min.y()) + kAbyss;
    const double longest = 2.0 * std::sqrt(2.0 * depth / collision::MoverSettings().gravity) + 5.0;
    const Tick ticks = walk.sim.ticks_of(longest);
    for (Tick tick = 0; tick < ticks && !body.state().grounded && !body.has_fallen_out_of_the_world();
         ++tick) {
        body.follow(intent, statistics);
    }
    return {std::max(0.0, start - body.foot().y()), body.state().grounded};
}

}  // namespace campuswalk::engine
