#include "tools/campuswalk/suggest/plan_visits.h"

#include <algorithm>
#include <optional>
#include <string>

#include "engine/walkspace/space/reach_point.h"

namespace campuswalk::tools {

using Eigen::Vector3d;
using engine::WalkNodeId;
using engine::WalkSpace;

namespace {

constexpr std::size_t kMaxBuildings = 3;
constexpr std::size_t kMaxRooms = 2;  // of each
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

bool holds(const scene::UprightBox& box, const Vector3d& foot) {
    return box.depth_of(foot + kWaist * Vector3d::UnitY()) >= 0.0;
}

/// By tile and node: how long the path is by which it was reached from a start, metres. 0 for starts, and for
/// places that one only gets to by a drop.
std::vector<std::vector<double>> path_lengths(const WalkSpace& reached) {
    constexpr double kUnknown = -1.0;
    constexpr double kDrop = 0.5;  // metres
    std::vector<std::vector<double>> lengths;
    for (const engine::WalkTile& tile : reached.tiles) {
        lengths.emplace_back(tile.nodes.size(), kUnknown);
    }
    const auto length_to = [&](const WalkNodeId& node) -> double& { return lengths[node.tile][node.node]; };
    const auto follow = [&](const WalkNodeId& from, const WalkNodeId& to) {
        const Vector3d stride = reached.position(to) - reached.position(from);
        const bool is_cut_off = length_to(from) == 0.0 && reached.parent(from);
        return stride.y() < -kDrop || is_cut_off ? 0.0 : length_to(from) + stride.norm();
    };
    std::vector<WalkNodeId> chain;
    for (std::uint32_t t = 0; t < reached.tiles.size(); ++t) {
        for (std::uint32_t n = 0; n < lengths[t].size(); ++n) {
            std::optional<WalkNodeId> at = WalkNodeId{t, static_cast<std::uint16_t>(n)};
            for (; at && length_to(*at) == kUnknown; at = reached.parent(*at)) {
                chain.push_back(*at);
            }
            for (; !chain.empty(); chain.pop_back()) {
                const std::optional<WalkNodeId> parent = reached.parent(chain.back());
                length_to(chain.back()) = parent ? follow(*parent, chain.back()) : 0.0;
            }
        }
    }
    return lengths;
}

/// Plans visits of buildings one by one, each from where the one before ended.
class BuildingVisits {
public:
    BuildingVisits(const WalkSpace& reached, engine::Strider& strider, const Vector3d& spawn,
                   const std::vector<scene::SuggestedBuilding>& buildings,
                   const std::vector<Interior>& interiors)
        : reached_(reached),
          strider_(strider),
          spawn_(spawn),
          buildings_(buildings),
          interiors_(interiors),
          is_visited_(buildings.size(), false),
          here_(spawn) {}

    /// Of the building that one starts in, if so.
    void visit_own_rooms() {
        for (std::size_t b = 0; b < buildings_.size(); ++b) {
            if (starts_inside(b)) {
                visit_rooms(b);
            }
        }
    }

    /// Enters the nearest building that can be, and two of its rooms. False if there is none.
    bool enter_nearest() {
        const auto building =
            visit_nearest([this](std::size_t b) { return place_inside(b); }, kInsideTrigger);
        if (building) {
            visit_rooms(*building);
        }
        return building.has_value();
    }

    bool approach_nearest() {
        return visit_nearest([this](std::size_t b) { return place_beside(b); }, kAroundTrigger).has_value();
    }

    /// To the place that is the longest way from the spawn, and to one that is far from both: whatever is
    /// shut on the way, the walk fails.
    void go_far() {
        const std::vector<WalkNodeId> open = open_places();
        const auto lengths = path_lengths(reached_);
        const auto length_to = [&](const WalkNodeId& node) { return lengths[node.tile][node.node]; };
        go_to_best_of(open, length_to);
        const Vector3d first = here_;
        go_to_best_of(open, [&](const WalkNodeId& node) {
            const Vector3d foot = reached_.position(node);
            return length_to(node) == 0.0 ? 0.0 : std::min((foot - spawn_).norm(), (foot - first).norm());
        });
    }

    std::vector<SuggestedVisit> visits;

private:
    bool starts_inside(std::size_t b) const {
        const std::optional<scene::UprightBox> box = trigger_inside(buildings_[b]);
        return box && holds(*box, spawn_);
    }

    /// To be where one starts says nothing about a door.
    std::optional<WalkNodeId> place_inside(std::size_t b) const {
        return starts_inside(b) ? std::nullopt : interiors_[b].place;
    }

    std::optional<WalkNodeId> place_beside(std::size_t b) const {
        const scene::UprightBox box = trigger_about(buildings_[b]);
        if (holds(box, spawn_)) {
            return std::nullopt;
        }
        return nearest_node(reached_, box_about(box), here_, [&](const Vector3d& foot) {
            return box.depth_of(foot + kWaist * Vector3d::UnitY()) >= kInside;
        });
    }

    /// Around the spawn, with floor on all sides.
    std::vector<WalkNodeId> open_places() const {
        constexpr double kFarthest = 40.0;  // metres
        constexpr int kAround = 2;          // cells
        const Vector3d far = Vector3d::Constant(kFarthest);
        std::vector<WalkNodeId> places = reached_.nodes_in({spawn_ - far, spawn_ + far});
        std::erase_if(places, [&](const WalkNodeId& node) {
            const engine::GridCell cell = reached_.cell_of(node);
            const double y = reached_.position(node).y();
            return reached_.node(node).hangs != 0 ||
                   std::ranges::any_of(engine::grid_directions(), [&](const engine::GridDirection& side) {
                       return !reached_.find({cell.x + kAround * side.x, cell.z + kAround * side.z}, y);
                   });
        });
        return places;
    }

    /// Nowhere if the best is hardly away from here.
    template <typename Worth>
    void go_to_best_of(const std::vector<WalkNodeId>& nodes, const Worth& worth) {
        constexpr double kNear = 3.0;  // metres
        const auto best = std::ranges::max_element(nodes, {}, worth);
        if (best != nodes.end() && worth(*best) > 0.0 && distance(*best) > kNear) {
            visit("", *best);
        }
    }

    double distance(const WalkNodeId& node) const { return (reached_.position(node) - here_).norm(); }

    void visit(const std::string& trigger, const WalkNodeId& node) {
        here_ = reached_.state_at(node, strider_).foot;
        visits.push_back({trigger, here_});
    }

    /// The building, if there was any.
    template <typename PlaceAt>
    std::optional<std::size_t> visit_nearest(const PlaceAt& place_at, const char* trigger) {
        std::optional<WalkNodeId> nearest;
        std::size_t chosen = 0;
        for (std::size_t b = 0; b < buildings_.size(); ++b) {
            const std::optional<WalkNodeId> node = is_visited_[b] ? std::nullopt : place_at(b);
            if (node && (!nearest || distance(*node) < distance(*nearest))) {
                nearest = node;
                chosen = b;
            }
        }
        if (!nearest) {
            return std::nullopt;
        }
        is_visited_[chosen] = true;
        visit(buildings_[chosen].id + trigger, *nearest);
        return chosen;
    }

    void visit_rooms(std::size_t building) {
        const std::vector<SuggestedRoom>& rooms = interiors_[building].rooms;
        std::vector<std::size_t> left;
        for (std::size_t r = 0; r < rooms.size(); ++r) {
            if (!holds(rooms[r].box, here_) && !holds(rooms[r].box, spawn_)) {
                left.push_back(r);
            }
        }
        for (std::size_t i = 0; i < kMaxRooms && !left.empty(); ++i) {
            const auto nearest =
                std::ranges::min_element(left, {}, [&](std::size_t r) { return distance(rooms[r].place); });
            visit(buildings_[building].id + room_trigger(*nearest), rooms[*nearest].place);
            left.erase(nearest);
        }
    }

    const WalkSpace& reached_;
    engine::Strider& strider_;
    const Vector3d& spawn_;
    const std::vector<scene::SuggestedBuilding>& buildings_;
    const std::vector<Interior>& interiors_;
    std::vector<bool> is_visited_;
    Vector3d here_;
};

}  // namespace

std::vector<SuggestedVisit> plan_visits(const WalkSpace& reached, engine::Strider& strider,
                                        const Vector3d& spawn,
                                        const std::vector<scene::SuggestedBuilding>& buildings,
                                        const std::vector<Interior>& interiors) {
    BuildingVisits plan(reached, strider, spawn, buildings, interiors);
    plan.visit_own_rooms();
    for (std::size_t i = 0; i < kMaxBuildings && (plan.enter_nearest() || plan.approach_nearest()); ++i) {
    }
    if (plan.visits.empty()) {
        plan.go_far();
    }
    return plan.visits;
}

void add_place_visits(const WalkSpace& reached, engine::Strider& strider, const Vector3d& spawn,
                      const std::vector<scene::Place>& places, std::vector<SuggestedVisit>& visits) {
    const bool leads_nowhere =
        std::ranges::all_of(visits, [](const SuggestedVisit& visit) { return visit.trigger.empty(); });
    Vector3d here = leads_nowhere ? spawn : visits.back().to;
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
