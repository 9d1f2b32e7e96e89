#include "engine/walkspace/route/unreachable.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "collision/world/obstacle.h"
#include "engine/script/travel.h"
#include "engine/walkspace/barrier/barrier_reason.h"
#include "engine/walkspace/barrier/island_barriers.h"
#include "engine/walkspace/barrier/place_check.h"
#include "engine/walkspace/explore/unreached_ground.h"
#include "engine/walkspace/route/keep_out.h"
#include "engine/walkspace/space/node_numbers.h"
#include "engine/walkspace/stride/opposing_contact.h"
#include "engine/walkspace/stride/worker_worlds.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// As much of the target's ground is looked at: 1,250 m² with cells of 0.25 m.
constexpr std::size_t kMostGround = 20'000;
/// Barriers are looked for this far around it, metres.
constexpr double kAroundGround = 12.0;
/// Islands around the target's that one might have to pass: the largest.
constexpr std::size_t kMostBetween = 12;

/// What a body at `at` stands on.
void find_ground(const Strider& strider, UnreachedSpot& spot) {
    const double radius = strider.settings().body.radius;
    const Vec3 center = spot.at.foot + Vec3(0, radius, 0);
    std::vector<collision::Obstacle> near;
    collision::gather_obstacles(strider.world(), strider.filter(), {center, center}, radius + 0.02, near);
    double lowest = std::numeric_limits<double>::max();
    for (const collision::Obstacle& piece : near) {
        if (const double y = collision::closest({center, center}, piece).on_shape.y(); y < lowest) {
            lowest = y;
            spot.object = piece.object;
            spot.triangle = piece.triangle;
        }
    }
}

/// A body that falls back from the target's ground may land between nodes that are reached.
bool is_beside_reached(const WalkSpace& reached, const Vec3& foot) {
    constexpr double kSameLevel = 0.3;
    const GridCell cell = reached.grid.cell_at(foot);
    for (int k = 0; k < 9; ++k) {
        if (reached.find({cell.x + k % 3 - 1, cell.z + k / 3 - 1}, foot.y(), kSameLevel)) {
            return true;
        }
    }
    return false;
}

/// The ground around the target that isn't reached.
Island ground_of(const WorkerWorlds& worlds, ExploreSettings settings, const GroundState& target,
                 const WalkSpace& reached, Strider& strider) {
    settings.more_starts = {target};
    settings.grid = reached.grid;
    settings.known = {&reached};
    settings.max_nodes = kMostGround;
    const WalkSpace space = explore(worlds, settings);
    Island island;
    NodeNumbers(space).for_each([&](const WalkNodeId& id) {
        const Vec3 foot = space.position(id);
        if (!is_beside_reached(reached, foot)) {
            island.spots.push_back({{foot, foot.y()}});
            find_ground(strider, island.spots.back());
            island.bounds.extend(foot);
        }
    });
    return island;
}

/// The islands around, the target's first: as explore finds them, or `ground` if that finds none there.
std::vector<Island> islands_around(const WorkerWorlds& worlds, ExploreSettings settings,
                                   const GroundState& target, const WalkSpace& reached,
                                   const Island& ground) {
    constexpr double kSameSpot = 0.5;  // metres
    settings.within = ground.bounds.grown(kAroundGround);
    settings.keep_out = nullptr;  // what is to be avoided is ground, too
    std::vector<Island> islands =
        find_unreached_ground(worlds, settings, reached, 0.0).value_or(std::vector<Island>());
    const auto apart = [&](const Island& island) {
        return (island.nearest_to(target.foot) - target.foot).norm();
    };
    const auto own = std::ranges::min_element(islands, {}, apart);
    if (own == islands.end() || apart(*own) > kSameSpot) {
        return {ground};
    }
    std::rotate(islands.begin(), own, own + 1);
    return islands;
}

/// Whether the barrier before the first of the islands may be on the far side of another one.
bool may_be_farther_off(const Barrier& barrier, const Island& first, std::span<const Island> others) {
    constexpr double kAtBarrier = 1.0;  // metres
    constexpr double kBeside = 2.0;
    const auto apart = [&](const Island& island) {
        return (island.nearest_to(barrier.at) - barrier.at).norm();
    };
    return !is_one_change(barrier.kind) || apart(first) > kBeside ||
           std::ranges::any_of(others, [&](const Island& other) { return apart(other) <= kAtBarrier; });
}

/// Why one doesn't get to the target and the ground around it, which may be that of several islands. Where
/// others lie on the path to its own, these are asked about too: each takes as long as the first.
std::optional<Barrier> barrier_before_target(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                             const GroundState& target, const WalkSpace& reached,
                                             const Island& ground, const scene::NodeTriangles& nodes) {
    auto barrier = find_island_barriers(worlds, settings, reached, {ground}, 1, &nodes, {true}).front();
    if (ground.spots.empty()) {
        return barrier;
    }
    const std::vector<Island> islands = islands_around(worlds, settings, target, reached, ground);
    const auto end = std::find_if(islands.begin() + 1, islands.end(), [&](const Island& island) {
        return island.area(reached.grid) <= kNotableIsland;
    });
    const std::span<const Island> others(islands.begin() + 1, end);
    if (others.empty() || (barrier && !may_be_farther_off(*barrier, islands.front(), others))) {
        return barrier;
    }
    const std::size_t count = 1 + std::min(others.size(), kMostBetween);
    const auto again =
        find_island_barriers(worlds, settings, reached, islands, count, &nodes, {true}).front();
    const bool leads_there = again && (is_one_change(again->kind) || again->kind == ReasonKind::sequence);
    return leads_there ? again : barrier;
}

/// How near one gets from the nearest node straight on, and what is in the way then.
Reason nearest_reason(const scene::Campus& campus, const WalkSpace& reached, const Target& target,
                      Strider& strider) {
    constexpr double kSeconds = 2.0;
    const auto apart = [&](const Vec3& p) {
        return (target.has_height ? Vec3(target.point - p) : flat(target.point - p)).norm();
    };
    std::optional<WalkNodeId> nearest;
    double least = std::numeric_limits<double>::max();
    NodeNumbers(reached).for_each([&](const WalkNodeId& id) {
        if (const double distance = apart(reached.position(id)); distance < least) {
            least = distance;
            nearest = id;
        }
    });
    if (!nearest) {
        return {.kind = ReasonKind::falls_out};
    }
    const GroundState node = reached.state_at(*nearest, strider);
    const StrideEnd end = strider.walk_to(node, target.point, 0.0, kSeconds);
    const bool is_nearer = end.kind == StrideEnd::Kind::grounded && apart(end.at.foot) < apart(node.foot);
    const Vec3 foot = is_nearer ? end.at.foot : node.foot;
    Reason reason;
    if (const auto contact = opposing_contact(campus.world, strider.filter(), strider.settings().body, foot,
                                              flat(target.point - foot))) {
        reason = reason_about(ReasonKind::contact, campus, contact->object, contact->at);
    }
    reason.kind = ReasonKind::no_nearer;
    reason.at = foot;
    reason.measured = apart(foot);
    return reason;
}

/// What is wrong with the target itself, and where it is.
Reason reason_at(const Vec3& point, Reason problem, const StrideSettings& strides) {
    problem.at = point;
    problem.look_at = point + 0.5 * strides.body.height * Vec3::UnitY();
    return problem;
}

Reason why_target_is_unreachable(const scene::Campus& campus, const RouteSettings& settings,
                                 const RouteRequest& request, const NoRoute& none) {
    Strider strider(campus.world, settings.strides, settings.solids);
    if (none.no_room) {
        const PlaceCheck place = check_place(campus, strider, none.target.point);
        return reason_at(none.target.point,
                         place.ground ? Reason{.kind = ReasonKind::no_room} : place.problem,
                         settings.strides);
    }
    if (none.reached.tiles.empty()) {
        return {.kind = ReasonKind::falls_out};
    }
    if (none.incomplete) {
        return {.kind = ReasonKind::unsearched, .measured = none.reached.area()};
    }
    if (settings.keep_out) {
        RouteSettings anywhere = settings;
        anywhere.keep_out = {};
        if (std::holds_alternative<Route>(plan_route(campus.world, anywhere, request))) {
            return why_avoided(campus, settings, request);
        }
    }
    Vec3 point = none.target.point;
    if (!none.target.has_height) {
        point.y() = request.from.foot.y();
    }
    const PlaceCheck place = check_place(campus, strider, point);
    if (!place.ground) {
        return reason_at(point, place.problem, settings.strides);
    }
    const WorkerWorlds worlds(campus.world, 1, {});
    ExploreSettings exploration;
    exploration.strides = settings.strides;
    exploration.solids = settings.solids;
    const Island ground = ground_of(worlds, exploration, *place.ground, none.reached, strider);
    const scene::NodeTriangles nodes(campus, ground.bounds.grown(kAroundGround));
    const auto barrier =
        barrier_before_target(worlds, exploration, *place.ground, none.reached, ground, nodes);
    return barrier ? reason_of(campus, *barrier) : nearest_reason(campus, none.reached, none.target, strider);
}

}  // namespace

Reason why_unreachable(const scene::Campus& campus, const RouteSettings& settings,
                       const RouteRequest& request, const NoRoute& none) {
    Reason why = why_target_is_unreachable(campus, settings, request, none);
    if (none.target.label == request.to.back().label) {
        return why;
    }
    return {.kind = ReasonKind::through, .name = none.target.label, .parts = {std::move(why)}};
}

}  // namespace campuswalk::engine
