#include "engine/walkspace/stride/worker_worlds.h"

namespace campuswalk::engine {

WorkerWorlds::WorkerWorlds(const collision::World& world, std::size_t workers,
                           const MakeBroadPhase& make_broad_phase)
    : world_(&world) {
    for (std::size_t worker = 1; worker < workers; ++worker) {
        auto copy = std::make_unique<collision::World>(make_broad_phase());
        for (std::size_t i = 0; i < world.size(); ++i) {
            copy->add(world.object(static_cast<collision::ObjectId>(i)));
        }
        copies_.push_back(std::move(copy));
    }
}

}  // namespace campuswalk::engine
