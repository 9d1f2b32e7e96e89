#include "collision/placement.h"

#include <vector>

#include "collision/closest.h"
#include "collision/mesh_collider.h"
#include "collision/obstacle.h"

namespace campuswalk::collision {

namespace {

bool inside(const std::shared_ptr<const MeshCollider>& mesh, const Vec3& local) {
    return mesh->closed_parts().contains(local);
}

template <typename Solid>
bool inside(const Solid& solid, const Vec3& local) {
    return closest(Segment{local, local}, solid, Pose{}).distance <= 0.0;
}

}  // namespace

bool contains(const Object& object, const Vec3& point) {
    const Vec3 local = object.X_world_shape.inverse_apply(point);
    return std::visit([&](const auto& shape) { return inside(shape, local); }, object.shape);
}

std::optional<ObjectId> obstruction(const World& world, const QueryFilter& filter, const Vec3& foot,
                                    double radius, double height, QueryCounters& counters) {
    const Segment body{foot + Vec3(0, radius, 0), foot + Vec3(0, height - radius, 0)};
    std::vector<Obstacle> pieces;
    gather_obstacles(world, filter, body, radius, pieces, counters);
    std::optional<ObjectId> worst;
    double least = radius;
    for (const Obstacle& piece : pieces) {
        if (const double distance = closest(body, piece).distance; distance < least) {
            worst = piece.object;
            least = distance;
        }
    }
    if (worst) {
        return worst;
    }
    Aabb box;
    box.extend(body.a);
    std::vector<ObjectId> around;
    world.candidates(box, filter, around);
    for (const ObjectId id : around) {
        if (contains(world.object(id), body.a)) {
            return id;
        }
    }
    return std::nullopt;
}

std::optional<Vec3> free_place(const World& world, const QueryFilter& filter, const Vec3& foot, double radius,
                               double height, double search, QueryCounters& counters) {
    constexpr double kStep = 0.05;  // metres
    for (int i = 0; i * kStep <= search; ++i) {
        const Vec3 tried = foot + Vec3(0, i * kStep, 0);
        if (!obstruction(world, filter, tried, radius, height, counters)) {
            return tried;
        }
    }
    return std::nullopt;
}

}  // namespace campuswalk::collision
