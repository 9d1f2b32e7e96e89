#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

#include "engine/walkspace/passage/traps.h"
#include "engine/walkspace/space/node_numbers.h"
#include "engine/walkspace/stride/removable_nodes.h"
#include "engine/walkspace/stride/worker_threads.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// Of so many traps it is found out.
constexpr std::size_t kMostTraps = 20;
/// From so many places where a trap ends, at most one in each square of this size, metres: where the ground
/// outside is the least higher, and where it is no higher than a step, as behind a gate.
constexpr std::size_t kMostClimbs = 12;
constexpr std::size_t kMostLevel = 8;
constexpr double kPlacesApart = 0.5;
/// Ground outside is looked for so many cells around.
constexpr int kCellsAround = 4;
/// A way out is no longer than this and leads no farther from them, metres; it is looked for on so many
/// cells. Without these bounds most of the time would go into gaps that only a slim body gets into.
constexpr double kLongestExit = 2.0;
constexpr double kAroundPlaces = 1.5;
constexpr std::size_t kMostExitNodes = 200;
/// Outside, bodies so far apart in height are at one node, metres.
constexpr double kSameNode = 0.3;
/// Who stands so near the top of an object stands on it, metres.
constexpr double kOnTop = 0.05;

/// Only cells and heights: what `ExploreSettings::known` is asked for.
WalkSpace space_of(const Trap& trap, const WalkSpace& space) {
    WalkSpace own(space.grid);
    for (const WalkNodeId& id : trap.nodes) {
        const GridCell cell = space.cell_of(id);
        const std::uint32_t number = own.add_tile_at(cell);
        WalkNode node = space.node(id);
        node.parent_tile = WalkNode::kStart;
        own.tiles[number].add(node);
    }
    return own;
}

/// Where a trap ends.
struct RimPlace {
    WalkNodeId node;
    double rise = 0.0;  ///< to ground outside, metres; higher than any ledge where there is none
};

class TrapExits {
public:
    TrapExits(const ExploreSettings& settings, const WalkSpace& space, const scene::NodeTriangles& nodes,
              const std::vector<Trap>& traps)
        : settings_(settings),
          space_(space),
          nodes_(nodes),
          numbers_(space),
          is_trapped_(numbers_.count(), false) {
        for (const Trap& trap : traps) {
            for (const WalkNodeId& id : trap.nodes) {
                is_trapped_[numbers_(id)] = true;
            }
        }
    }

    /// For several threads, each with a world of its own.
    std::optional<Barrier> barrier_of(const Trap& trap, const collision::World& world) const {
        const WorkerWorlds own_world(world, 1, {});
        const WalkSpace own = space_of(trap, space_);
        const PassageQuery query = query_of(trap, own, world);
        ExploreSettings settings = settings_;
        settings.max_nodes = kMostExitNodes;
        std::optional<Barrier> barrier = barrier_in(why_not(own_world, settings, query));
        if (barrier && barrier->kind != ReasonKind::solid) {
            barrier = without_floors(std::move(*barrier), world);
        }
        if (barrier && barrier->kind == ReasonKind::solid) {
            return trap.drop > kHighestRiser ? std::optional(ledge_into(trap)) : std::nullopt;
        }
        return barrier;
    }

private:
    PassageQuery query_of(const Trap& trap, const WalkSpace& own, const collision::World& world) const {
        Strider strider(world, settings_.strides, settings_.solids);
        PassageQuery query;
        query.likely_riser = trap.drop;
        for (const RimPlace& place : places_of(trap, own)) {
            query.from.push_back(space_.state_at(place.node, strider));
            query.within.extend(query.from.back().foot);
            if (!is_level(place)) {
                query.likely_riser = std::min(*query.likely_riser, place.rise);
            }
        }
        query.within = query.within.grown(kAroundPlaces);
        query.is_beyond = [this](const GridCell& cell, double y) {
            const auto node = space_.find(cell, y, kSameNode);
            return node && !is_trapped_[numbers_(*node)];
        };
        query.known = {&own};
        query.nodes = &nodes_;
        query.changes = Changes::single;
        query.longest_crossing = kLongestExit;
        return query;
    }

    bool is_level(const RimPlace& place) const { return place.rise <= settings_.strides.body.step_height; }

    std::vector<RimPlace> places_of(const Trap& trap, const WalkSpace& own) const {
        std::vector<RimPlace> rim = rim_of(trap, own);
        std::set<GridCell> taken;
        std::size_t climbs = 0;
        std::size_t level = 0;
        std::erase_if(rim, [&](const RimPlace& place) {
            const bool is_one_more = is_level(place) ? level < kMostLevel : climbs < kMostClimbs;
            if (!is_one_more ||
                !taken.insert(WalkGrid{kPlacesApart}.cell_at(space_.position(place.node))).second) {
                return true;
            }
            ++(is_level(place) ? level : climbs);
            return false;
        });
        return rim;
    }

    /// The least rise first.
    std::vector<RimPlace> rim_of(const Trap& trap, const WalkSpace& own) const {
        const double step = settings_.strides.body.step_height + WalkNode::kLevel;
        std::vector<RimPlace> rim;
        for (const WalkNodeId& id : trap.nodes) {
            const GridCell cell = space_.cell_of(id);
            const auto y = static_cast<double>(space_.node(id).y);
            const bool ends_here = std::ranges::any_of(grid_directions(), [&](const GridDirection& d) {
                return !own.find({cell.x + d.x, cell.z + d.z}, y, step);
            });
            if (ends_here) {
                rim.push_back({id, rise_around(cell, y)});
            }
        }
        std::ranges::stable_sort(rim, {}, &RimPlace::rise);
        return rim;
    }

    double rise_around(const GridCell& cell, double y) const {
        double least = 2.0 * kHighestLedge;
        for (int dz = -kCellsAround; dz <= kCellsAround; ++dz) {
            for (int dx = -kCellsAround; dx <= kCellsAround; ++dx) {
                const auto node = space_.find({cell.x + dx, cell.z + dz}, y, kHighestLedge);
                if (node && !is_trapped_[numbers_(*node)]) {
                    least = std::min(least, static_cast<double>(space_.node(*node).y) - y);
                }
            }
        }
        return least;
    }

    /// The smallest change but for those that take away what one stands on outside: the pit's wall is no
    /// gate. `solid` if there is no other.
    Barrier without_floors(Barrier smallest, const collision::World& world) const {
        std::vector<Barrier> changes = std::exchange(smallest.parts, {});
        changes.insert(changes.begin(), std::move(smallest));
        std::erase_if(changes, [&](const Barrier& change) {
            return change.kind == ReasonKind::object && carries_ground(bounds_of_change(change, world));
        });
        if (changes.empty()) {
            return {};
        }
        Barrier other = std::move(changes.front());
        changes.erase(changes.begin());
        other.parts = std::move(changes);
        return other;
    }

    /// Of the object or the node that it takes away.
    collision::Aabb bounds_of_change(const Barrier& change, const collision::World& world) const {
        const auto node =
            change.is_node ? nodes_.of_same_node(*change.object, change.triangle) : std::nullopt;
        return node ? bounds_of(world, *change.object, *node) : world.bounds(*change.object);
    }

    bool carries_ground(const collision::Aabb& solid) const {
        collision::Aabb top = solid;
        top.min.y() = solid.max.y() - kOnTop;
        top.max.y() = solid.max.y() + kOnTop;
        return std::ranges::any_of(space_.nodes_in(top),
                                   [&](const WalkNodeId& id) { return !is_trapped_[numbers_(id)]; });
    }

    /// The edge over which one got in.
    Barrier ledge_into(const Trap& trap) const {
        Barrier ledge;
        ledge.kind = ReasonKind::ledge;
        ledge.measured = trap.drop;
        ledge.allowed = settings_.strides.body.step_height;
        ledge.at = trap.edge;
        ledge.from = space_.position(trap.entrance);
        return ledge;
    }

    const ExploreSettings& settings_;
    const WalkSpace& space_;
    const scene::NodeTriangles& nodes_;
    NodeNumbers numbers_;
    std::vector<bool> is_trapped_;  ///< by node
};

}  // namespace

void find_trap_barriers(const WorkerWorlds& worlds, const ExploreSettings& settings, const WalkSpace& space,
                        const scene::NodeTriangles& nodes, std::vector<Trap>& traps) {
    const TrapExits exits(settings, space, nodes, traps);
    for_each_item(std::min(traps.size(), kMostTraps), worlds.size(), [&](std::size_t worker, std::size_t i) {
        traps[i].out = exits.barrier_of(traps[i], worlds[worker]);
    });
}

}  // namespace campuswalk::engine
