#include "tools/campuswalk_bench/walk/our_walker.h"

#include <memory>
#include <stdexcept>

#include "collision/geometry/trigonometry.h"
#include "collision/mesh/mesh_collider.h"
#include "collision/world/placement.h"
#include "tools/campuswalk_bench/measure/heap.h"

namespace campuswalk::tools::bench {

using collision::Vec3;

namespace {

constexpr double kSearch = 0.5;  ///< metres, like engine/simulation/simulation.h

collision::MoverSettings settings_of(const WalkBody& body) {
    collision::MoverSettings settings;
    settings.height = body.height;
    settings.radius = body.radius;
    settings.step_height = body.step_height;
    settings.min_up = collision::sin_cos(body.max_slope).cos;
    settings.gravity = body.gravity;
    return settings;
}

}  // namespace

OurWalker::OurWalker(const collision::TriangleMesh& mesh, const WalkBody& body)
    : world_(std::make_unique<collision::LinearBroadPhase>()),
      body_(body),
      settings_(settings_of(body)),
      mover_(world_, settings_, {}) {
    collision::Object ground;
    ground.shape = std::make_shared<const collision::MeshCollider>(mesh);
    world_.add(ground);
}

void OurWalker::place(const Vec3& foot) {
    const auto free = free_place(world_, {}, foot, settings_.radius, settings_.height, kSearch);
    if (!free) {
        throw std::runtime_error("a path of the benchmark starts where there is no free place");
    }
    mover_.place(state_, *free, 2.0 * kSearch, cache_);
}

void OurWalker::walk(const Vec3& desired) {
    mover_.move(state_, desired, body_.tick, cache_, trace_);
}

std::size_t OurWalker::release_working_memory() {
    const std::size_t before = heap_in_use();
    cache_ = {};
    trace_ = {};
    return before - heap_in_use() + sizeof(mover_) + sizeof(cache_) + sizeof(trace_) + sizeof(state_);
}

}  // namespace campuswalk::tools::bench
