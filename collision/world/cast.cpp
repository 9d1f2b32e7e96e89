#include "collision/world/cast.h"

#include <vector>

#include "collision/mesh/mesh_query.h"

namespace campuswalk::collision {

namespace {

/// Surfaces this close together along the ray count as one, metres.
constexpr double kSamePlace = 1e-3;

/// Where a ray in the shape's frame first hits it.
struct FirstHit {
    const Ray& ray;
    QueryStatistics* statistics;

    std::optional<double> operator()(const std::shared_ptr<const MeshCollider>& mesh) const {
        const auto found = first_on_ray(*mesh, ray, statistics);
        return found ? std::optional(found->fraction) : std::nullopt;
    }
    template <typename Solid>
    std::optional<double> operator()(const Solid& solid) const {
        add_to(statistics, {.primitive_tests = 1});
        return hit(ray, solid);
    }
};

}  // namespace

std::optional<WorldRayHit> cast(const World& world, const QueryFilter& filter, const Ray& ray,
                                Detection preferred, QueryStatistics* statistics) {
    thread_local std::vector<ObjectId> candidates;
    world.candidates(ray.from, ray.to, filter, candidates);
    const double length = (ray.to - ray.from).norm();
    if (length <= 0.0) {
        return std::nullopt;
    }
    std::optional<WorldRayHit> best;
    std::optional<WorldRayHit> best_preferred;
    for (const ObjectId id : candidates) {
        const Object& object = world.object(id);
        const Pose& X = object.X_world_shape;
        const Ray local{X.inverse_apply(ray.from), X.inverse_apply(ray.to)};
        const auto f = std::visit(FirstHit{local, statistics}, object.shape);
        if (!f) {
            continue;
        }
        if (!best || *f < best->fraction) {
            best = WorldRayHit{id, *f};
        }
        if (any_of(object.detection, preferred) && (!best_preferred || *f < best_preferred->fraction)) {
            best_preferred = WorldRayHit{id, *f};
        }
    }
    if (best_preferred && best_preferred->fraction <= best->fraction + kSamePlace / length) {
        return best_preferred;
    }
    return best;
}

}  // namespace campuswalk::collision
