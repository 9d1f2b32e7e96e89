#include "engine/walkspace/one_way.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "collision/geometry/disjoint_sets.h"
#include "engine/walkspace/neighbour_joiner.h"
#include "engine/walkspace/node_numbers.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// Edges nearer than this along the ground, in cells, and in height, in metres, are one hole's.
constexpr int kSameHole = 3;
constexpr double kSameHeight = 0.5;
/// How often it is tried to get from one part of the space into another before that counts as impossible;
/// before a trap is reported, every way out of it has been tried.
constexpr std::size_t kTries = 200;
/// From so many places in a trap, winding ways out are tried as well, of legs that take so many seconds.
constexpr std::size_t kWindingStarts = 16;
constexpr double kLeg = 1.0;

/// Parts of a walk space in which one can walk back wherever one came from, and which of them lead home to a
/// start.
class Parts {
public:
    Parts(const WorkerWorlds& worlds, const ExploreSettings& settings, const WalkSpace& space)
        : space_(space),
          numbers_(space),
          sets_(numbers_.count()),
          strider_(worlds[0], settings.strides, settings.solids),
          step_(settings.strides.body.step_height) {
        numbers_.for_each([&](const WalkNodeId& ref) {
            if (const auto parent = space.parent(ref); parent && space.node(ref).returns == 1) {
                sets_.join(numbers_(ref), numbers_(*parent));
            }
        });
        for (const WalkNodeId& start : space.starts) {
            home_.insert(part_of(start));
        }
    }

    /// Nodes by part that is no one's way home, after all ways were tried.
    std::map<std::size_t, std::vector<WalkNodeId>> without_path_home() {
        std::map<std::size_t, std::vector<WalkNodeId>> parts = others();
        // A part whose parent's part it is entered from by a stride makes the parent's part lead where it
        // leads.
        for (bool changed = true; changed;) {
            changed = false;
            for (const auto& [part, nodes] : parts) {
                if (!leads_home(part) && finds_path(nodes)) {
                    mark_home(part);
                    changed = true;
                }
            }
        }
        std::erase_if(parts, [&](const auto& part) { return leads_home(part.first); });
        return parts;
    }

    /// Every stride from every node, steered in each way if it falls: does one lead home?
    bool has_any_path(const std::vector<WalkNodeId>& nodes) {
        return std::ranges::any_of(nodes, [&](const WalkNodeId& ref) {
            const GroundState at = space_.state_at(ref, strider_);
            for (std::uint8_t direction = 0; direction < 8; ++direction) {
                for (std::uint8_t steering : {Stride::kStraightOn, Stride::kLetGo}) {
                    if (leads_home_from(at, {.direction = direction, .steering = steering})) {
                        return true;
                    }
                }
            }
            return false;
        });
    }

    /// Two legs in any directions, sliding along what is in the way: does one end where there is a way home?
    /// In a corner, no stride of a cell may lead out.
    bool has_winding_path(const std::vector<WalkNodeId>& nodes) {
        const std::size_t every = std::max<std::size_t>(1, nodes.size() / kWindingStarts);
        for (std::size_t i = 0; i < nodes.size(); i += every) {
            const GroundState start = space_.state_at(nodes[i], strider_);
            for (const GridDirection& first : grid_directions()) {
                const auto middle = walk_on(start, first);
                if (!middle) {
                    continue;
                }
                for (const GridDirection& second : grid_directions()) {
                    if (const auto end = walk_on(*middle, second); end && leads_home_at(*end)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

private:
    std::optional<GroundState> walk_on(const GroundState& from, const GridDirection& direction) {
        const double far = 2.0 * kLeg * strider_.settings().walk_speed;
        const StrideEnd end = strider_.walk_to(from, from.foot + far * direction.unit, 0.02, kLeg);
        return end.kind == StrideEnd::Kind::grounded ? std::optional(end.at) : std::nullopt;
    }

    bool leads_home_at(const GroundState& at) {
        const auto there = space_.find(space_.grid.cell_at(at.foot), at.foot.y());
        return there && leads_home(part_of(*there));
    }

    std::size_t part_of(const WalkNodeId& ref) { return sets_.root(numbers_(ref)); }
    bool leads_home(std::size_t part) const { return home_.contains(part); }

    std::map<std::size_t, std::vector<WalkNodeId>> others() {
        std::map<std::size_t, std::vector<WalkNodeId>> parts;
        numbers_.for_each([&](const WalkNodeId& ref) {
            if (const std::size_t part = part_of(ref); !leads_home(part)) {
                parts[part].push_back(ref);
            }
        });
        return parts;
    }

    /// The part leads home, and so does every part that leads into it.
    void mark_home(std::size_t part) {
        home_.insert(part);
        for_each_start_of(part, [&](const WalkNodeId& parent) {
            if (const std::size_t before = part_of(parent); !leads_home(before)) {
                mark_home(before);
            }
        });
    }

    template <typename Visit>
    void for_each_start_of(std::size_t part, const Visit& visit) {
        if (entered_.empty()) {
            numbers_.for_each([&](const WalkNodeId& ref) {
                const auto parent = space_.parent(ref);
                if (parent && space_.node(ref).returns == 0) {
                    entered_[part_of(ref)].push_back(*parent);
                }
            });
        }
        for (const WalkNodeId& parent : entered_[part]) {
            visit(parent);
        }
    }

    /// Tries where its nodes lie beside others that lead home.
    bool finds_path(const std::vector<WalkNodeId>& nodes) {
        std::size_t tries = 0;
        for (const WalkNodeId& ref : nodes) {
            const GridCell cell = space_.cell_of(ref);
            const double y = static_cast<double>(space_.node(ref).y);
            for (std::uint8_t direction = 0; direction < 8; ++direction) {
                const GridDirection& d = grid_directions()[direction];
                const auto beside = space_.find({cell.x + d.x, cell.z + d.z}, y, step_ + WalkNode::kLevel);
                if (!beside || !leads_home(part_of(*beside))) {
                    continue;
                }
                if (leads_home_from(space_.state_at(ref, strider_), {.direction = direction})) {
                    return true;
                }
                if (++tries == kTries) {
                    return false;
                }
            }
        }
        return false;
    }

    bool leads_home_from(const GroundState& at, const Stride& stride) {
        const StrideEnd end = strider_.take(at, stride, space_.grid);
        return end.kind == StrideEnd::Kind::grounded && leads_home_at(end.at);
    }

    const WalkSpace& space_;
    NodeNumbers numbers_;
    collision::DisjointSets sets_;
    Strider strider_;
    double step_;
    std::set<std::size_t> home_;
    std::map<std::size_t, std::vector<WalkNodeId>> entered_;  ///< by part: from where
};

/// Parts of one pit, between which one can't walk back, are one trap.
void join_neighbours(std::vector<Trap>& traps, const WalkSpace& space) {
    collision::DisjointSets sets(traps.size());
    NeighbourJoiner joiner(sets, kSameHeight);
    for (std::size_t i = 0; i < traps.size(); ++i) {
        for (const WalkNodeId& id : traps[i].nodes) {
            joiner.add(space.cell_of(id), static_cast<double>(space.node(id).y), i);
        }
    }
    for (std::size_t i = 0; i < traps.size(); ++i) {
        if (Trap& whole = traps[sets.root(i)]; &whole != &traps[i]) {
            whole.nodes.insert(whole.nodes.end(), traps[i].nodes.begin(), traps[i].nodes.end());
            traps[i].nodes.clear();
        }
    }
    std::erase_if(traps, [](const Trap& trap) { return trap.nodes.empty(); });
}

}  // namespace

std::vector<Trap> find_traps(const WorkerWorlds& worlds, const ExploreSettings& settings,
                             const WalkSpace& space) {
    Parts parts(worlds, settings, space);
    std::vector<Trap> traps;
    Strider strider(worlds[0], settings.strides, settings.solids);
    for (auto& [part, nodes] : parts.without_path_home()) {
        if (parts.has_any_path(nodes) || parts.has_winding_path(nodes)) {
            continue;
        }
        Trap trap;
        trap.nodes = std::move(nodes);
        trap.entrance = trap.nodes.front();
        for (const WalkNodeId& ref : trap.nodes) {
            if (space.node(ref).returns == 0) {
                trap.entrance = ref;
                break;
            }
        }
        trap.edge = edge_below(
            state_of(space.state_at(space.parent(trap.entrance).value_or(trap.entrance), strider)));
        trap.drop = trap.edge.y() - static_cast<double>(space.node(trap.entrance).y);
        traps.push_back(std::move(trap));
    }
    join_neighbours(traps, space);
    std::ranges::stable_sort(traps, std::greater(), [](const Trap& trap) { return trap.nodes.size(); });
    return traps;
}

std::vector<Hole> find_holes(const WalkSpace& space) {
    std::vector<Hole::Edge> edges;
    for (std::uint32_t t = 0; t < space.tiles.size(); ++t) {
        for (const WalkTile::Drop& drop : space.tiles[t].drops) {
            edges.push_back({{t, drop.node}, drop.stride, drop.edge});
        }
    }
    std::map<GridCell, std::vector<std::size_t>> by_cell;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        by_cell[space.grid.cell_at(edges[i].at)].push_back(i);
    }
    collision::DisjointSets sets(edges.size());
    for (const auto& [cell, here] : by_cell) {
        for (int dx = 0; dx <= kSameHole; ++dx) {
            for (int dz = dx == 0 ? 0 : -kSameHole; dz <= kSameHole; ++dz) {
                const auto near = by_cell.find({cell.x + dx, cell.z + dz});
                if (near == by_cell.end()) {
                    continue;
                }
                for (const std::size_t a : here) {
                    for (const std::size_t b : near->second) {
                        if (std::abs(edges[a].at.y() - edges[b].at.y()) <= kSameHeight) {
                            sets.join(a, b);
                        }
                    }
                }
            }
        }
    }
    std::map<std::size_t, Hole> holes;
    std::map<std::size_t, std::set<GridCell>> cells;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const std::size_t root = sets.root(i);
        if (cells[root].insert(space.grid.cell_at(edges[i].at)).second) {
            holes[root].edges.push_back(edges[i]);
            holes[root].length += space.grid.cell;
        }
    }
    std::vector<Hole> result;
    for (auto& [root, hole] : holes) {
        result.push_back(std::move(hole));
    }
    std::ranges::stable_sort(result, std::greater(), &Hole::length);
    return result;
}

}  // namespace campuswalk::engine
