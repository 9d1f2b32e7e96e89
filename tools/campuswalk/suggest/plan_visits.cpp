#include "tools/campuswalk/suggest/plan_visits.h"

#include <algorithm>
#include <optional>

#include "engine/walkspace/reach_point.h"

namespace campuswalk::tools {

using Eigen::Vector3d;
using engine::WalkNodeId;
using engine::WalkSpace;

namespace {

constexpr std::size_t kMaxVisits = 3;
constexpr std::size_t kMaxPlaceVisits = 5;
constexpr double kInside = 0.5;  // metres: the breadth of a shoulder, and where in its cell it is

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
                                        const std::vector<scene::SuggestedBuilding>& buildings,
                                        const std::vector<std::optional<WalkNodeId>>& interiors) {
    std::vector<SuggestedVisit> visits;
    std::vector<bool> visited(buildings.size(), false);
    Vector3d here = spawn;
    const auto visit = [&](const std::string& trigger, const WalkNodeId& node) {
        here = reached.state_at(node, strider).foot;
        visits.push_back({trigger, here});
    };
    const auto beside = [&](std::size_t b) {
        const scene::UprightBox box = trigger_about(buildings[b]);
        if (box.depth_of(spawn + kWaist * Vector3d::UnitY()) >= 0.0) {
            return std::optional<WalkNodeId>();
        }
        return nearest_node(reached, box_about(box), here, [&](const Vector3d& foot) {
            return box.depth_of(foot + kWaist * Vector3d::UnitY()) >= kInside;
        });
    };
    const auto visit_nearest = [&](const auto& place_at, const char* trigger) {
        std::optional<WalkNodeId> nearest;
        std::size_t chosen = 0;
        const auto distance = [&](const WalkNodeId& node) { return (reached.position(node) - here).norm(); };
        for (std::size_t b = 0; b < buildings.size(); ++b) {
            const std::optional<WalkNodeId> node = visited[b] ? std::nullopt : place_at(b);
            if (node && (!nearest || distance(*node) < distance(*nearest))) {
                nearest = node;
                chosen = b;
            }
        }
        if (nearest) {
            visited[chosen] = true;
            visit(buildings[chosen].id + trigger, *nearest);
        }
        return nearest.has_value();
    };
    // To be where one starts says nothing about a door.
    const auto inside = [&](std::size_t b) {
        const std::optional<scene::UprightBox> box = trigger_inside(buildings[b]);
        const bool starts_there = box && box->depth_of(spawn + kWaist * Vector3d::UnitY()) >= 0.0;
        return starts_there ? std::nullopt : interiors[b];
    };
    while (visits.size() < kMaxVisits &&
           (visit_nearest(inside, "/inside") || visit_nearest(beside, "/around"))) {
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

void add_place_visits(const WalkSpace& reached, engine::Strider& strider, const Vector3d& spawn,
                      const std::vector<scene::Place>& places, std::vector<SuggestedVisit>& visits) {
    const bool leads_nowhere = visits.size() == 1 && visits.front().trigger.empty();
    Vector3d here = visits.empty() || leads_nowhere ? spawn : visits.back().to;
    std::vector<const scene::Place*> left;
    left.reserve(places.size());
    for (const scene::Place& place : places) {
        left.push_back(&place);
    }
    std::vector<SuggestedVisit> to_places;
    while (!left.empty() && to_places.size() < kMaxPlaceVisits) {
        const auto nearest = std::ranges::min_element(left, {}, [&](const scene::Place* place) {
            return collision::horizontal_norm(place->position - here);
        });
        const scene::Place& place = **nearest;
        left.erase(nearest);
        const engine::PointReach reach =
            engine::reach_point(reached, strider, place.position, place.has_height);
        if (reach.node) {
            here = reach.foot;
            to_places.push_back({"", here, place.name});
        }
    }
    if (leads_nowhere && !to_places.empty()) {
        visits.clear();
    }
    visits.insert(visits.end(), to_places.begin(), to_places.end());
}

}  // namespace campuswalk::tools
