#pragma once

#include <optional>

#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/report/triangle_density.h"

namespace campuswalk::engine {

/// Where so many triangles are that walking about there takes far longer than elsewhere, such as among the
/// leaves of plants: the most crowded quarter of the ground, but only places with over a thousand triangles
/// near them, and only if walking about on all of it would take long.
class CrowdedPlaces {
public:
    /// Looks at the ground within `settings.within`.
    CrowdedPlaces(const collision::World& world, const ExploreSettings& settings);

    bool contains(const collision::Vec3& foot) const { return limit_ && density_.around(foot) > *limit_; }

    /// How many triangles a place that isn't crowded has near it at most; none if no place is crowded.
    const std::optional<double>& limit() const { return limit_; }

private:
    TriangleDensity density_;
    std::optional<double> limit_;
};

}  // namespace campuswalk::engine
