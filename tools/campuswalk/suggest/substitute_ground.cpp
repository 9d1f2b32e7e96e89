#include "tools/campuswalk/suggest/substitute_ground.h"

#include <algorithm>

#include "tools/campuswalk/suggest/campus_text.h"

namespace campuswalk::tools {

using Eigen::Vector3d;

namespace {

/// The height of the lowest of a building's doors, or of its bottom if it has none.
double threshold_of(const scene::SuggestedBuilding& building, const std::vector<scene::Door>& doors) {
    constexpr double kBeside = 0.5;    // metres from a door to the walls of its building
    constexpr double kLeafGap = 0.05;  // metres below a leaf
    const double bottom = building.box.center.y() - 0.5 * building.box.size.y();
    double lowest = 1e300;
    for (const scene::Door& door : doors) {
        const bool is_its = building.box.depth_of(door.foot + kWaist * Vector3d::UnitY()) >= -kBeside;
        lowest = is_its ? std::min(lowest, door.foot.y()) : lowest;
    }
    return lowest > bottom + kLeafGap && lowest < 1e300 ? lowest : bottom;
}

}  // namespace

scene::Bounds substitute_ground(const scene::ModelReport& report,
                                const std::vector<scene::SuggestedBuilding>& buildings) {
    constexpr double kMargin = 20.0;    // metres
    constexpr double kThickness = 0.5;  // metres
    const scene::Bounds& model = report.bounds;
    std::vector<double> bottoms;
    bottoms.reserve(buildings.size());
    for (const scene::SuggestedBuilding& building : buildings) {
        bottoms.push_back(threshold_of(building, report.doors));
    }
    std::sort(bottoms.begin(), bottoms.end());
    const Vector3d around(kMargin, 0.0, kMargin);
    scene::Bounds ground{model.min - around, model.max + around};
    ground.max.y() = bottoms.empty() ? model.min.y() : bottoms[bottoms.size() / 2];
    ground.min.y() = ground.max.y() - kThickness;
    return ground;
}

}  // namespace campuswalk::tools
