#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "collision/world/broad_phase.h"
#include "collision/world/world.h"

namespace campuswalk::engine {

/// A world for each thread: queries of Bullet's broad phase aren't thread-safe. They share the meshes.
class WorkerWorlds {
public:
    using MakeBroadPhase = std::function<std::unique_ptr<collision::BroadPhase>()>;

    /// `world` must outlive it; it is the first worker's. For one worker, `make_broad_phase` isn't called.
    WorkerWorlds(const collision::World& world, std::size_t workers, const MakeBroadPhase& make_broad_phase);

    std::size_t size() const { return 1 + copies_.size(); }
    const collision::World& operator[](std::size_t worker) const {
        return worker == 0 ? *world_ : *copies_[worker - 1];
    }

private:
    const collision::World* world_;
    std::vector<std::unique_ptr<collision::World>> copies_;
};

}  // namespace campuswalk::engine
