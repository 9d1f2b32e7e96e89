#include "collision/world/broad_phase.h"

#include "collision/geometry/ray.h"

namespace campuswalk::collision {

void LinearBroadPhase::insert(ObjectId id, const Aabb& box) {
    entries_.push_back({id, box});
}

void LinearBroadPhase::overlapping(const Aabb& box, std::vector<ObjectId>& out) const {
    for (const Entry& entry : entries_) {
        if (entry.box.overlaps(box)) {
            out.push_back(entry.id);
        }
    }
}

void LinearBroadPhase::crossing(const Vec3& from, const Vec3& to, std::vector<ObjectId>& out) const {
    for (const Entry& entry : entries_) {
        const Vec3 center = entry.box.center();
        const Box box{0.5 * (entry.box.max - entry.box.min)};
        if (hit(Ray{from - center, to - center}, box)) {
            out.push_back(entry.id);
        }
    }
}

}  // namespace campuswalk::collision
