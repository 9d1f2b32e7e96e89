#pragma once

#include <optional>

#include "collision/base/query_statistics.h"
#include "collision/geometry/ray.h"
#include "collision/world/world.h"

namespace campuswalk::collision {

struct WorldRayHit {
    ObjectId object{};
    double fraction = 0.0;  ///< of the ray, 0 at its start
};

/// The first object on the ray that passes the filter. Of objects hit at one point (a solid object and one
/// for gaze hits often share a mesh), one with the detection `preferred`, else that with the lowest id.
std::optional<WorldRayHit> cast(const World& world, const QueryFilter& filter, const Ray& ray,
                                Detection preferred, QueryStatistics* statistics = nullptr);

}  // namespace campuswalk::collision
