#include "collision/world/world.h"

#include <algorithm>
#include <utility>

#include "collision/world/bounds.h"

namespace campuswalk::collision {

World::World(std::unique_ptr<BroadPhase> broad_phase) : broad_phase_(std::move(broad_phase)) {}

ObjectId World::add(Object object) {
    const auto id = static_cast<ObjectId>(objects_.size());
    const Aabb box = bounds_of(object.shape, object.X_world_shape);
    objects_.push_back(std::move(object));
    bounds_.push_back(box);
    total_bounds_.extend(box);
    broad_phase_->insert(id, box);
    return id;
}

void World::candidates(const Aabb& box, const QueryFilter& filter, std::vector<ObjectId>& out) const {
    out.clear();
    broad_phase_->overlapping(box, out);
    apply_filter(filter, out);
}

void World::candidates(const Vec3& from, const Vec3& to, const QueryFilter& filter,
                       std::vector<ObjectId>& out) const {
    out.clear();
    broad_phase_->crossing(from, to, out);
    apply_filter(filter, out);
}

void World::apply_filter(const QueryFilter& filter, std::vector<ObjectId>& out) const {
    std::erase_if(out, [&](ObjectId id) {
        const Object& o = object(id);
        if (filter.disabled != nullptr && (*filter.disabled)[index_of(id)]) {
            return true;
        }
        return !any_of(o.detection, filter.detection) || ((filter.ignored_layers >> o.layer) & 1U) != 0;
    });
    std::sort(out.begin(), out.end());
}

}  // namespace campuswalk::collision
