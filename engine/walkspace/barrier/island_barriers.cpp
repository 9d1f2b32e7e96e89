#include "engine/walkspace/barrier/island_barriers.h"

#include <algorithm>

#include "engine/walkspace/barrier/ground_gap.h"
#include "engine/walkspace/barrier/hollows.h"
#include "engine/walkspace/barrier/island_approaches.h"
#include "engine/walkspace/barrier/island_sequences.h"
#include "engine/walkspace/stride/worker_threads.h"

namespace campuswalk::engine {

namespace {

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
    ledge.kind = BarrierKind::ledge;
    ledge.measured = lowest.rise();
    ledge.allowed = step_height;
    ledge.at = lowest.spot->at.foot;
    ledge.object = lowest.spot->object;
    ledge.triangle = lowest.spot->triangle;
    ledge.from = lowest.from.foot;
    return ledge;
}

bool is_closed_off(const std::optional<Barrier>& barrier) {
    return barrier && barrier->kind == BarrierKind::solid;
}

/// Whether it is an object, and the other one too, but a larger one.
bool is_smaller_object(const collision::World& world, const Barrier& barrier, const Barrier& other) {
    const auto size_of = [&](const Barrier& object) {
        const collision::Aabb& box = world.bounds(*object.object);
        return (box.max - box.min).norm();
    };
    return barrier.kind == BarrierKind::object && other.kind == BarrierKind::object &&
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
        if (here && here->kind != BarrierKind::solid && here->kind != BarrierKind::object) {
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
    if (is_wanted && barrier && barrier->kind == BarrierKind::ledge) {
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
