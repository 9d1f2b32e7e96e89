#include "tools/campuswalk/suggest/plan_visits.h"

#include <optional>

namespace campuswalk::tools {

using Eigen::Vector3d;
using engine::WalkNodeId;
using engine::WalkSpace;

namespace {

constexpr std::size_t kMaxVisits = 3;
constexpr double kInside = 0.5;  // metres: the breadth of a shoulder, and where in its cell it is
constexpr double kWaist = 0.9;   // metres above the feet

/// Around the box, as its feet may be.
collision::Aabb around(const scene::UprightBox& box) {
    const Vector3d half =
        (0.5 * box.size.x() * box.along.cwiseAbs() + 0.5 * box.size.z() * box.across().cwiseAbs()) +
        Vector3d(0.0, 0.5 * box.size.y() + kWaist, 0.0);
    return {box.center - half, box.center + half};
}

/// The reached node nearest to `from` whose foot point satisfies `is_target`.
template <typename Predicate>
std::optional<WalkNodeId> nearest_node(const WalkSpace& reached, const collision::Aabb& within,
                                       const Vector3d& from, const Predicate& is_target) {
    std::optional<WalkNodeId> best;
    double nearest = 1e300;
    for (const WalkNodeId& node : reached.nodes_in(within)) {
        const Vector3d foot = reached.position(node);
        const double distance = (foot - from).norm();
        if (reached.node(node).hangs == 0 && distance < nearest && is_target(foot)) {
            nearest = distance;
            best = node;
        }
    }
    return best;
}

}  // namespace

std::vector<SuggestedVisit> plan_visits(const WalkSpace& reached, engine::Strider& strider,
                                        const Vector3d& spawn,
                                        std::vector<scene::SuggestedBuilding> buildings) {
    std::vector<SuggestedVisit> visits;
    Vector3d here = spawn;
    const auto visit = [&](const std::string& building, const WalkNodeId& node) {
        here = reached.state_at(node, strider).foot;
        visits.push_back({building, here});
    };
    while (visits.size() < kMaxVisits) {
        std::optional<WalkNodeId> nearest;
        std::size_t chosen = 0;
        const auto distance = [&](const WalkNodeId& node) { return (reached.position(node) - here).norm(); };
        for (std::size_t b = 0; b < buildings.size(); ++b) {
            const scene::UprightBox box = trigger_about(buildings[b]);
            const auto node = nearest_node(reached, around(box), here, [&](const Vector3d& foot) {
                return box.depth_of(foot + kWaist * Vector3d::UnitY()) >= kInside;
            });
            if (node && (!nearest || distance(*node) < distance(*nearest))) {
                nearest = node;
                chosen = b;
            }
        }
        if (!nearest) {
            break;
        }
        visit(buildings[chosen].id, *nearest);
        buildings.erase(buildings.begin() + static_cast<std::ptrdiff_t>(chosen));
    }
    if (visits.empty()) {
        constexpr double kStroll = 5.0;  // metres
        const Vector3d far = Vector3d::Constant(4.0 * kStroll);
        if (const auto end = nearest_node(reached, {here - far, here + far}, here, [&](const Vector3d& foot) {
                return (foot - here).norm() >= kStroll;
            })) {
            visit("", *end);
        }
    }
    return visits;
}

}  // namespace campuswalk::tools
