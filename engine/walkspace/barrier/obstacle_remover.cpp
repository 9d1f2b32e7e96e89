#include "engine/walkspace/barrier/obstacle_remover.h"

#include <algorithm>

#include "collision/world/obstacle.h"
#include "engine/walkspace/stride/partial_world.h"
#include "engine/walkspace/stride/removable_nodes.h"

namespace campuswalk::engine {

using collision::Aabb;
using collision::ObjectId;
using collision::Obstacle;
using collision::Vec3;

namespace {

/// Objects that are taken away for a try, the nearest to where the body stopped first.
constexpr std::size_t kMostObjects = 12;
/// A world without a node is copied this far beyond the box in which paths are searched for, metres.
constexpr double kAroundSearch = 2.0;

bool supports(const collision::World& world, ObjectId id, const GroundState& at, double radius) {
    const Vec3 center = at.foot + Vec3(0, radius, 0);
    std::vector<Obstacle> near;
    collision::gather_pieces(world, id, {center, center}, radius + 0.01, near);
    return std::ranges::any_of(near, [&](const Obstacle& piece) {
        return carries(at, collision::closest({center, center}, piece), radius);
    });
}

}  // namespace

void ObstacleRemover::try_objects(std::vector<ObjectId> touched, std::vector<Change>& found) {
    const Vec3 center = probe_.query().within.center();
    std::ranges::stable_sort(touched, {}, [&](ObjectId id) {
        return (probe_.world().bounds(id).center() - center).squaredNorm();
    });
    std::size_t tried = 0;
    for (const ObjectId id : touched) {
        if (probe_.is_exhausted() || carries_a_start(id) || tried == kMostObjects) {
            continue;
        }
        ++tried;
        if (const auto path = probe_.find_path_without(id)) {
            found.push_back(without(id, *path));
            found.back().barrier.object = id;
        }
    }
}

void ObstacleRemover::try_nodes(double largest, std::vector<Change>& found) {
    const PassageQuery& query = probe_.query();
    if (query.nodes == nullptr) {
        return;
    }
    const Aabb around = query.within.grown(kAroundSearch);
    for (const RemovableNode& node :
         removable_nodes(probe_.world(), probe_.solids(), probe_.body(), *query.nodes, query.from, largest)) {
        const auto world = world_without(probe_.world(), node.object, node.triangles, around);
        if (world == nullptr || probe_.is_exhausted()) {
            continue;
        }
        if (const auto path = probe_.find_path_in(*world)) {
            Change change = without(node.object, *path);
            Barrier& barrier = change.barrier;
            if (barrier.object != node.object || !node.triangles.contains(barrier.triangle)) {
                barrier.at = node.at;
            }
            barrier.object = node.object;
            barrier.triangle = node.triangle;
            barrier.is_node = true;
            std::erase_if(found, [&](const Change& other) {
                return other.barrier.kind == ReasonKind::object && other.barrier.object == node.object;
            });
            found.push_back(std::move(change));
            return;
        }
    }
}

/// Taking away the ground is no change that helps.
bool ObstacleRemover::carries_a_start(ObjectId id) const {
    const Aabb& box = probe_.world().bounds(id);
    return std::ranges::any_of(probe_.query().from, [&](const GroundState& at) {
        const Vec3 below = at.foot - Vec3(0, 0.02, 0);
        return (below.array() >= box.min.array() - 0.01).all() &&
               (below.array() <= box.max.array() + 0.01).all() && at.support_y <= box.max.y() + 0.01 &&
               supports(probe_.world(), id, at, probe_.body().radius);
    });
}

Change ObstacleRemover::without(ObjectId id, const FoundPath& path) const {
    const Aabb& box = probe_.world().bounds(id);
    Change change{{}, (box.max - box.min).norm(), whole_length(path)};
    change.barrier.kind = ReasonKind::object;
    probe_.locate(path, change.barrier);
    return change;
}

/// The way leads from where the body was put down to the middle of what is beyond, straight on from where it
/// gets there, metres: without a part of a wall near the door, the way as far as the wall may be shorter, but
/// hardly the one into the room.
double ObstacleRemover::whole_length(const FoundPath& path) const {
    const PassageQuery& query = probe_.query();
    double length = path.length;
    if (query.middle) {
        length += collision::horizontal_norm(*query.middle - path.feet.back());
    }
    if (!query.known.empty()) {
        const WalkSpace& reached = *query.known.front();
        const Vec3& foot = path.start.foot;
        const auto node = reached.find(reached.grid.cell_at(foot), foot.y());
        length += node ? reached.length_to(*node) : 0.0;
    }
    return length;
}

}  // namespace campuswalk::engine
