#include "tools/campuswalk/suggest/plan_visits.h"

#include <optional>
#include <utility>

namespace campuswalk::tools {

using Eigen::Vector3d;
using scene::WalkableGround;

namespace {

constexpr std::size_t kMaxVisits = 3;
constexpr double kInside = 0.3;  // metres: the breadth of a shoulder
constexpr double kWaist = 0.9;   // metres above the feet

/// The nearest spot to `from` that can be reached and whose foot point satisfies `is_target`.
template <typename Predicate>
std::optional<std::uint32_t> nearest_spot(const WalkableGround& ground,
                                          const std::vector<std::uint32_t>& paths, const Vector3d& from,
                                          const Predicate& is_target) {
    std::optional<std::uint32_t> best;
    double nearest = 1e300;
    for (std::uint32_t s = 0; s < paths.size(); ++s) {
        const Vector3d& foot = ground.spots()[s].foot;
        const double distance = (foot - from).norm();
        if (paths[s] != s && ground.spots()[s].edge_distance > 0 && distance < nearest && is_target(foot)) {
            nearest = distance;
            best = s;
        }
    }
    return best;
}

}  // namespace

std::vector<SuggestedVisit> plan_visits(std::uint32_t spawn, const WalkableGround& ground,
                                        std::vector<scene::SuggestedBuilding> buildings) {
    std::vector<SuggestedVisit> visits;
    std::uint32_t at = spawn;
    const auto visit = [&](const std::string& building, const std::vector<std::uint32_t>& paths,
                           std::uint32_t end) {
        std::vector<Vector3d> waypoints = ground.waypoints(paths, end);
        waypoints.erase(waypoints.begin());
        visits.push_back({building, std::move(waypoints)});
        at = end;
    };
    while (visits.size() < kMaxVisits) {
        const std::vector<std::uint32_t> paths = ground.shortest_paths_from(at);
        const Vector3d& here = ground.spots()[at].foot;
        std::optional<std::uint32_t> nearest;
        std::size_t chosen = 0;
        for (std::size_t b = 0; b < buildings.size(); ++b) {
            const scene::UprightBox box = trigger_about(buildings[b]);
            const auto spot = nearest_spot(ground, paths, here, [&](const Vector3d& foot) {
                return box.depth_of(foot + kWaist * Vector3d::UnitY()) >= kInside;
            });
            if (spot && (!nearest || (ground.spots()[*spot].foot - here).norm() <
                                         (ground.spots()[*nearest].foot - here).norm())) {
                nearest = spot;
                chosen = b;
            }
        }
        if (!nearest) {
            break;
        }
        visit(buildings[chosen].id, paths, *nearest);
        buildings.erase(buildings.begin() + static_cast<std::ptrdiff_t>(chosen));
    }
    if (visits.empty()) {
        constexpr double kStroll = 5.0;  // metres
        const std::vector<std::uint32_t> paths = ground.shortest_paths_from(spawn);
        const Vector3d& here = ground.spots()[spawn].foot;
        const auto end = nearest_spot(ground, paths, here,
                                      [&](const Vector3d& foot) { return (foot - here).norm() >= kStroll; });
        if (end) {
            visit("", paths, *end);
        }
    }
    return visits;
}

}  // namespace campuswalk::tools
