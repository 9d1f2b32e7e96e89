#include "engine/walkspace/barrier/island_barriers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/world/cast.h"
#include "engine/walkspace/barrier/hollows.h"
#include "engine/walkspace/barrier/island_approaches.h"
#include "engine/walkspace/barrier/island_sequences.h"
#include "engine/walkspace/stride/worker_threads.h"

namespace campuswalk::engine {

using collision::Ray;
using collision::Vec3;

namespace {

/// Ground that is so much higher or lower at one end than at the other is a roof, or below one, metres.
constexpr double kSameLevel = 1.0;
/// Where there might be ground between is looked for this far above and below the line, metres.
constexpr double kAboveLine = 0.9;
constexpr double kBelowLine = 0.9;
/// How far apart, and how near to both ends, metres.
constexpr double kEvery = 0.25;
constexpr double kEnds = 0.5;

struct Pair {
    const GroundState* from = nullptr;
    const UnreachedSpot* to = nullptr;
    double apart = std::numeric_limits<double>::max();
};

Pair nearest_pair(const Island& island, const std::vector<GroundState>& reached) {
    Pair nearest;
    for (const GroundState& from : reached) {
        for (const UnreachedSpot& spot : island.spots) {
            const double apart = collision::horizontal_norm(spot.at.foot - from.foot);
            if (apart < nearest.apart && std::abs(spot.at.foot.y() - from.foot.y()) <= kSameLevel) {
                nearest = {&from, &spot, apart};
            }
        }
    }
    return nearest;
}

/// Nothing in the way of a look from one to the other, and no ground below it but at its ends.
bool is_void_between(const collision::World& world, const ExploreSettings& settings, const Vec3& from,
                     const Vec3& to) {
    const auto is_hit = [&](const Ray& ray) {
        return collision::cast(world, settings.solids, ray, collision::Detection::solid).has_value();
    };
    const Vec3 eye(0, 0.5 * settings.strides.body.height, 0);
    if (is_hit({from + eye, to + eye})) {
        return false;
    }
    const auto is_ground_at = [&](double share) {
        const Vec3 p = from + share * (to - from);
        return is_hit({p + Vec3(0, kAboveLine, 0), p - Vec3(0, kBelowLine, 0)});
    };
    const double length = collision::horizontal_norm(to - from);
    if (is_ground_at(0.5)) {
        return false;
    }
    for (int i = 0; kEnds + i * kEvery < length - kEnds; ++i) {
        if (is_ground_at((kEnds + i * kEvery) / length)) {
            return false;
        }
    }
    return true;
}

/// Whether an island lies apart from the ground that is reached with nothing between, as one piece of a
/// terrain beside another: from the nearest of these states that is at about its height to its nearest spot,
/// over which one sees from there, and without ground below all that line. None if something stands between,
/// or if there is ground.
std::optional<Barrier> find_gap(const collision::World& world, const ExploreSettings& settings,
                                const Island& island, const std::vector<GroundState>& reached) {
    const Pair pair = nearest_pair(island, reached);
    if (pair.to == nullptr || !is_void_between(world, settings, pair.from->foot, pair.to->at.foot)) {
        return std::nullopt;
    }
    Barrier gap;
    gap.kind = ReasonKind::gap;
    gap.measured = pair.apart;
    gap.at = pair.to->at.foot;
    gap.from = pair.from->foot;
    gap.object = pair.to->object;
    gap.triangle = pair.to->triangle;
    return gap;
}

/// What keeps the body from the island where nothing of it is near.
std::optional<Barrier> barrier_from_afar(const IslandQuestion& q, Changes changes) {
    const auto query = passage_from_afar(q, changes);
    return query ? barrier_in(why_not(q.worlds, q.settings, *query)) : std::nullopt;
}

std::optional<Barrier> gap_before(const IslandQuestion& q) {
    std::vector<GroundState> reached;
    for (const Approach& approach : approaches_from_afar(q)) {
        reached.push_back(approach.from);
    }
    return find_gap(q.worlds[0], q.settings, q.island, reached);
}

/// The lowest step up to the island from what is near it.
Barrier lowest_ledge(const std::vector<Approach>& approaches, double step_height) {
    const Approach& lowest = lowest_of(approaches);
    Barrier ledge;
    ledge.kind = ReasonKind::ledge;
    ledge.measured = lowest.rise();
    ledge.allowed = step_height;
    ledge.at = lowest.spot->at.foot;
    ledge.object = lowest.spot->object;
    ledge.triangle = lowest.spot->triangle;
    ledge.from = lowest.from.foot;
    return ledge;
}

bool is_closed_off(const std::optional<Barrier>& barrier) {
    return barrier && barrier->kind == ReasonKind::solid;
}

/// Whether it is an object, and the other one too, but a larger one.
bool is_smaller_object(const collision::World& world, const Barrier& barrier, const Barrier& other) {
    const auto size_of = [&](const Barrier& object) {
        const collision::Aabb& box = world.bounds(*object.object);
        return (box.max - box.min).norm();
    };
    return barrier.kind == ReasonKind::object && other.kind == ReasonKind::object &&
           size_of(barrier) <= size_of(other);
}

/// `approaches`: at least one. `is_wanted`: see find_island_barriers.
std::optional<Barrier> barrier_from_nearby(const IslandQuestion& q, const std::vector<Approach>& approaches,
                                           bool is_wanted) {
    const Barrier ledge = lowest_ledge(approaches, q.settings.strides.body.step_height);
    if (ledge.measured > kHighestLedge) {
        return ledge;
    }
    PassageQuery query = passage_nearby(q, approaches);
    std::optional<bool> enclosed;
    query.is_enclosed = [&] {
        if (!enclosed) {
            enclosed = is_enclosed(q.worlds[0], q.settings, q.reached, q.island);
        }
        return *enclosed;
    };
    if (is_wanted) {
        query.changes = Changes::single;
        std::optional<Barrier> here = barrier_in(why_not(q.worlds, q.settings, query));
        if (here && here->kind != ReasonKind::solid && here->kind != ReasonKind::object) {
            return here;
        }
        // One change that helps from afar is better than several here, or than to take away a wall.
        std::optional<Barrier> afar = barrier_from_afar(q, Changes::single);
        if (afar && !is_closed_off(afar) && !(here && is_smaller_object(q.worlds[0], *here, *afar))) {
            return afar;
        }
        if (!is_closed_off(here)) {
            return here;
        }
        query.changes = Changes::any;
    }
    std::optional<Barrier> barrier = barrier_in(why_not(q.worlds, q.settings, query));
    const bool is_ledge = is_closed_off(barrier) && ledge.measured > kHighestRiser && !query.is_enclosed();
    return is_ledge ? ledge : barrier;
}

std::optional<Barrier> barrier_before(const IslandQuestion& q, bool is_wanted) {
    const std::vector<Approach> approaches = approaches_to(q);
    if (approaches.empty()) {
        const auto barrier = is_wanted ? barrier_from_afar(q, Changes::single) : std::nullopt;
        const bool is_explained = barrier && !is_closed_off(barrier);
        const auto gap = is_explained ? std::nullopt : gap_before(q);
        return gap ? gap : barrier;
    }
    std::optional<Barrier> barrier = barrier_from_nearby(q, approaches, is_wanted);
    if (is_wanted && barrier && barrier->kind == ReasonKind::ledge) {
        const auto climb = barrier_from_afar(q, Changes::climbs);
        return climb ? climb : barrier;
    }
    const auto gap = is_closed_off(barrier) ? gap_before(q) : std::nullopt;
    return gap ? gap : barrier;
}

}  // namespace

std::vector<std::optional<Barrier>> find_island_barriers(const WorkerWorlds& worlds,
                                                         const ExploreSettings& settings,
                                                         const WalkSpace& reached,
                                                         const std::vector<Island>& islands,
                                                         std::size_t count, const scene::NodeTriangles* nodes,
                                                         const std::vector<bool>& wanted) {
    Rim rim;
    for (const WalkTile& tile : reached.tiles) {
        for (const WalkTile::Keyframe& at : tile.rim) {
            rim.add(at.at.foot, at.at);
        }
    }
    std::vector<std::optional<Barrier>> barriers(std::min(count, islands.size()));
    for_each_item(barriers.size(), worlds.size(), [&](std::size_t worker, std::size_t island) {
        const WorkerWorlds own(worlds[worker], 1, {});
        const bool is_wanted = island < wanted.size() && wanted[island];
        barriers[island] = barrier_before({own, settings, reached, islands[island], rim, nodes}, is_wanted);
    });
    find_sequences({worlds, settings, reached, islands, nodes, wanted}, barriers);
    return barriers;
}

}  // namespace campuswalk::engine
