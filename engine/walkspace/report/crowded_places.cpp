#include "engine/walkspace/report/crowded_places.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "engine/walkspace/explore/unreached_surfaces.h"
#include "scene/base/quantile.h"

namespace campuswalk::engine {

CrowdedPlaces::CrowdedPlaces(const collision::World& world, const ExploreSettings& settings)
    : density_(world) {
    constexpr double kCell = 1.0;             // metres
    constexpr double kMostWork = 2e6;         // triangles near places, each counted at each: some seconds
    constexpr double kNeverCrowded = 1000.0;  // triangles
    constexpr double kUncrowded = 0.75;       // of the ground
    const WalkGrid grid{kCell};
    const collision::Aabb& region = settings.within.empty() ? world.bounds() : settings.within;
    std::vector<double> triangles;
    for (const Surface& surface : walkable_surfaces(world, settings, grid, region)) {
        collision::Vec3 foot = grid.center(surface.cell);
        foot.y() = surface.y;
        triangles.push_back(density_.around(foot));
    }
    if (std::accumulate(triangles.begin(), triangles.end(), 0.0) > kMostWork) {
        limit_ = std::max(kNeverCrowded, scene::quantile(std::move(triangles), kUncrowded));
    }
}

}  // namespace campuswalk::engine
