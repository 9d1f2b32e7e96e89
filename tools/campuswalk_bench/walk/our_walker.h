#pragma once

#include <cstddef>

#include "collision/mover/mover.h"
#include "collision/world/world.h"
#include "tools/campuswalk_bench/engine/engine.h"

namespace campuswalk::tools::bench {

/// Our mover in a world with only the mesh. One mover walks all paths, as one avatar would.
class OurWalker final : public WalkEngine {
public:
    OurWalker(const collision::TriangleMesh& mesh, const WalkBody& body);

    /// Throws std::runtime_error if there is no free place up to half a metre above.
    void place(const collision::Vec3& foot) override;
    void walk(const collision::Vec3& desired) override;
    collision::Vec3 foot() const override { return state_.foot; }

    /// Frees the cache and the trace; returns the bytes that the mover, its state, cache and trace took after
    /// all the walks, without what is on the heap where heaps aren't counted (heap.h).
    std::size_t release_working_memory();

private:
    collision::World world_;
    WalkBody body_;
    collision::MoverSettings settings_;
    collision::CapsuleMover mover_;
    collision::MoverCache cache_;
    collision::MoveTrace trace_;
    collision::MoverState state_;
};

}  // namespace campuswalk::tools::bench
