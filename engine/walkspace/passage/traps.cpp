#include "engine/walkspace/passage/traps.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "collision/geometry/disjoint_sets.h"
#include "engine/walkspace/space/neighbour_joiner.h"
#include "engine/walkspace/space/node_numbers.h"
#include "engine/walkspace/space/paths_home.h"
#include "engine/walkspace/space/strong_components.h"
#include "engine/walkspace/stride/worker_threads.h"

namespace campuswalk::engine {

namespace {

/// Parts no farther apart in height than this are one pit's, metres.
constexpr double kSameHeight = 0.5;
/// How often it is tried to get from one part of the space into another before that counts as impossible;
/// before a trap is reported, every way out of it has been tried.
constexpr std::size_t kTries = 200;
/// So often parts are asked anew whether those that now lead home are beside them; then every way is tried.
constexpr int kRounds = 8;
/// From so many places in a trap, winding ways out are tried as well, of legs that take so many seconds.
constexpr std::size_t kWindingStarts = 16;
constexpr double kLeg = 1.0;
/// From so many parts legs are walked before what they lead to is noted.
constexpr std::size_t kPartsAtOnce = 64;

/// The exact states of nodes, asked for in order of their numbers: those of a tile by a stride from each to
/// the next.
class StatesInOrder {
public:
    StatesInOrder(const WalkSpace& space, Strider& strider) : space_(space), strider_(strider) {}

    GroundState at(const WalkNodeId& id) {
        if (id.tile != tile_) {
            tile_ = id.tile;
            known_.clear();
        }
        const auto parent = space_.parent(id);
        const auto known = parent && parent->tile == tile_ ? known_.find(parent->node) : known_.end();
        const bool is_stored = space_.tiles[id.tile].keyframe(id.node) != nullptr;
        GroundState state = is_stored || known == known_.end()
                                ? space_.state_at(id, strider_)
                                : strider_.take(known->second, space_.node(id).stride(), space_.grid).at;
        known_.emplace(id.node, state);
        return state;
    }

private:
    const WalkSpace& space_;
    Strider& strider_;
    std::uint32_t tile_ = 0;
    std::map<std::uint16_t, GroundState> known_;  ///< by the nodes' numbers in the tile
};

/// One thread's body, which looks for ways out of a part. A search returns what parts it came into; it
/// ends once it comes into one that leads home.
class PartWalker {
public:
    PartWalker(const collision::World& world, const ExploreSettings& settings, const WalkSpace& space,
               const Parts& parts, const PathsHome& home)
        : settings_(settings),
          space_(space),
          parts_(parts),
          home_(home),
          strider_(world, settings.strides, settings.solids) {}

    /// By strides from its nodes to others beside them that lead home.
    std::set<Part> search_beside(const std::vector<WalkNodeId>& nodes) {
        std::set<Part> found;
        const double level = strider_.settings().body.step_height + WalkNode::kLevel;
        std::size_t tries = 0;
        for (const WalkNodeId& id : nodes) {
            const GridCell cell = space_.cell_of(id);
            const double y = static_cast<double>(space_.node(id).y);
            for (std::uint8_t direction = 0; direction < 8; ++direction) {
                const GridDirection& d = grid_directions()[direction];
                const auto beside = space_.find({cell.x + d.x, cell.z + d.z}, y, level);
                if (!beside || !home_.lead_from(parts_.of(*beside))) {
                    continue;
                }
                const GroundState at = space_.state_at(id, strider_);
                if (leads_home(strider_.take(at, {.direction = direction}, space_.grid), found) ||
                    ++tries == kTries) {
                    return found;
                }
            }
        }
        return found;
    }

    /// By every stride from every node.
    std::set<Part> search_by_strides(const std::vector<WalkNodeId>& nodes) {
        std::set<Part> found;
        StatesInOrder states(space_, strider_);
        for (const WalkNodeId& id : nodes) {
            const GroundState at = states.at(id);
            for (std::uint8_t direction = 0; direction < 8; ++direction) {
                if (any_stride_leads_home(at, direction, found)) {
                    return found;
                }
            }
        }
        return found;
    }

    /// Where one stands after a leg in any direction, sliding along what is in the way, from some of the
    /// nodes.
    std::vector<GroundState> walk_legs(const std::vector<WalkNodeId>& nodes) {
        std::vector<GroundState> ends;
        const std::size_t every = std::max<std::size_t>(1, nodes.size() / kWindingStarts);
        for (std::size_t i = 0; i < nodes.size(); i += every) {
            walk_legs_from(space_.state_at(nodes[i], strider_), [&](const StrideEnd& end) {
                if (end.kind == StrideEnd::Kind::grounded) {
                    ends.push_back(end.at);
                }
            });
        }
        return ends;
    }

    std::set<Part> parts_one_leg_from(const GroundState& at) {
        std::set<Part> found;
        walk_legs_from(at, [&](const StrideEnd& end) {
            if (const auto there = parts_.at(end)) {
                found.insert(*there);
            }
        });
        return found;
    }

private:
    /// Straight on or straight down if it falls; and at a run or with a jump, where the space was explored
    /// so.
    bool any_stride_leads_home(const GroundState& at, std::uint8_t direction, std::set<Part>& found) {
        const auto leads_there = [&](Gait gait, std::uint8_t steering) {
            return leads_home(strider_.take(at, {direction, gait, steering}, space_.grid), found);
        };
        const StrideEnd walked = strider_.take(at, {.direction = direction}, space_.grid);
        return leads_home(walked, found) || (walked.left_ground && leads_there(Gait::walk, Stride::kLetGo)) ||
               (walked.left_ground && settings_.run && leads_there(Gait::run, Stride::kStraightOn)) ||
               (settings_.jump && leads_there(Gait::jump, Stride::kStraightOn));
    }

    bool leads_home(const StrideEnd& end, std::set<Part>& found) const {
        const auto there = parts_.at(end);
        if (there) {
            found.insert(*there);
        }
        return there && home_.lead_from(*there);
    }

    template <typename Visit>
    void walk_legs_from(const GroundState& from, const Visit& visit) {
        const double far = 2.0 * kLeg * strider_.settings().walk_speed;
        for (const GridDirection& direction : grid_directions()) {
            visit(strider_.walk_to(from, from.foot + far * direction.unit, 0.02, kLeg));
        }
    }

    const ExploreSettings& settings_;
    const WalkSpace& space_;
    const Parts& parts_;
    const PathsHome& home_;
    Strider strider_;
};

/// Looks for ways home from all parts, on several threads.
class TrapSearch {
public:
    TrapSearch(const WorkerWorlds& worlds, const ExploreSettings& settings, const WalkSpace& space)
        : space_(space), parts_(space), home_(space, parts_) {
        for (std::size_t i = 0; i < worlds.size(); ++i) {
            walkers_.emplace_back(worlds[i], settings, space, parts_, home_);
        }
        parts_.for_each_node([&](const WalkNodeId& id) {
            if (const Part part = parts_.of(id); !home_.lead_from(part)) {
                nodes_of_[part].push_back(id);
            }
        });
    }

    /// The nodes of parts that lead home by none of the ways that were tried; of those between which one can
    /// walk both ways together.
    std::vector<std::vector<WalkNodeId>> run() && {
        for (int round = 0; round < kRounds && leads_home_by(&PartWalker::search_beside); ++round) {
        }
        leads_home_by(&PartWalker::search_by_strides);
        walk_two_legs();
        return joined();
    }

private:
    using Search = std::set<Part> (PartWalker::*)(const std::vector<WalkNodeId>& nodes);

    /// From each part for itself, so that the order makes no difference. Whether any turned out to lead home.
    bool leads_home_by(Search search) {
        const std::vector<Part> from = unsolved();
        std::vector<std::set<Part>> found(from.size());
        for_each_item(from.size(), walkers_.size(), [&](std::size_t worker, std::size_t i) {
            found[i] = (walkers_[worker].*search)(nodes_of_.at(from[i]));
        });
        for (std::size_t i = 0; i < from.size(); ++i) {
            note(from[i], found[i]);
        }
        return forget_solved();
    }

    /// In a corner, no stride of a cell may lead out. After the first leg, bodies that stand in one cell at
    /// one height are taken for one: the first.
    void walk_two_legs() {
        std::map<std::pair<GridCell, int>, std::set<Part>> one_leg_from;
        for (std::vector<Part> from = first_unsolved(0); !from.empty();
             from = first_unsolved(from.back() + 1)) {
            std::vector<std::vector<GroundState>> ends(from.size());
            for_each_item(from.size(), walkers_.size(), [&](std::size_t worker, std::size_t i) {
                ends[i] = walkers_[worker].walk_legs(nodes_of_.at(from[i]));
            });
            std::vector<std::pair<GroundState, std::set<Part>*>> unknown;
            for (const std::vector<GroundState>& ends_of_part : ends) {
                for (const GroundState& at : ends_of_part) {
                    if (const auto [known, is_new] = one_leg_from.try_emplace(place_of(at)); is_new) {
                        unknown.emplace_back(at, &known->second);
                    }
                }
            }
            for_each_item(unknown.size(), walkers_.size(), [&](std::size_t worker, std::size_t i) {
                *unknown[i].second = walkers_[worker].parts_one_leg_from(unknown[i].first);
            });
            for (std::size_t i = 0; i < from.size(); ++i) {
                for (const GroundState& at : ends[i]) {
                    note(from[i], one_leg_from.at(place_of(at)));
                }
            }
        }
        forget_solved();
    }

    std::pair<GridCell, int> place_of(const GroundState& at) const {
        return {space_.grid.cell_at(at.foot), static_cast<int>(std::floor(at.foot.y() / WalkNode::kLevel))};
    }

    std::vector<std::vector<WalkNodeId>> joined() const {
        const std::vector<Part> parts = unsolved();
        const auto index_of = [&](Part part) {
            return static_cast<std::uint32_t>(std::ranges::lower_bound(parts, part) - parts.begin());
        };
        std::vector<std::vector<std::uint32_t>> targets(parts.size());
        home_.for_each_other(
            [&](Part from, Part into) { targets[index_of(from)].push_back(index_of(into)); });
        const std::vector<std::uint32_t> first_of = strong_components(targets);
        std::vector<std::vector<WalkNodeId>> nodes(parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::vector<WalkNodeId>& of_part = nodes_of_.at(parts[i]);
            std::vector<WalkNodeId>& together = nodes[first_of[i]];
            together.insert(together.end(), of_part.begin(), of_part.end());
        }
        std::erase_if(nodes, [](const auto& none) { return none.empty(); });
        return nodes;
    }

    std::vector<Part> unsolved() const {
        std::vector<Part> parts;
        for (const auto& [part, nodes] : nodes_of_) {
            parts.push_back(part);
        }
        return parts;
    }
    /// As many as are walked from at once, from this one on.
    std::vector<Part> first_unsolved(Part lowest) const {
        std::vector<Part> parts;
        for (auto at = nodes_of_.lower_bound(lowest); at != nodes_of_.end() && parts.size() < kPartsAtOnce;
             ++at) {
            if (!home_.lead_from(at->first)) {
                parts.push_back(at->first);
            }
        }
        return parts;
    }
    void note(Part from, const std::set<Part>& found) {
        for (const Part into : found) {
            home_.add(from, into);
        }
    }
    /// Whether there were any.
    bool forget_solved() {
        return std::erase_if(nodes_of_, [&](const auto& part) { return home_.lead_from(part.first); }) > 0;
    }

    const WalkSpace& space_;
    const Parts parts_;
    PathsHome home_;
    std::vector<PartWalker> walkers_;
    std::map<Part, std::vector<WalkNodeId>> nodes_of_;  ///< of parts that lead home by no path found so far
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

/// Where one gets into each from ground that isn't trapped; or from another trap, if that leads nowhere else.
void find_entrances(const collision::World& world, const ExploreSettings& settings, const WalkSpace& space,
                    std::vector<Trap>& traps) {
    const NodeNumbers numbers(space);
    std::vector<const Trap*> trap_of(numbers.count(), nullptr);
    for (const Trap& trap : traps) {
        for (const WalkNodeId& id : trap.nodes) {
            trap_of[numbers(id)] = &trap;
        }
    }
    Strider strider(world, settings.strides, settings.solids);
    for (Trap& trap : traps) {
        std::optional<WalkNodeId> entrance;
        for (const WalkNodeId& id : trap.nodes) {
            const auto from = space.parent(id);
            const Trap* const before = from ? trap_of[numbers(*from)] : &trap;
            if (before == nullptr) {
                entrance = id;
                break;
            }
            if (before != &trap && !entrance) {
                entrance = id;
            }
        }
        trap.entrance = entrance.value_or(trap.nodes.front());
        const WalkNodeId last = space.parent(trap.entrance).value_or(trap.entrance);
        trap.edge = edge_below(state_of(space.state_at(last, strider)));
        trap.drop = trap.edge.y() - static_cast<double>(space.node(trap.entrance).y);
    }
}

}  // namespace

std::vector<Trap> find_traps(const WorkerWorlds& worlds, const ExploreSettings& settings,
                             const WalkSpace& space) {
    std::vector<Trap> traps;
    for (std::vector<WalkNodeId>& nodes : TrapSearch(worlds, settings, space).run()) {
        traps.emplace_back().nodes = std::move(nodes);
    }
    join_neighbours(traps, space);
    find_entrances(worlds[0], settings, space, traps);
    std::ranges::stable_sort(traps, std::greater(), [](const Trap& trap) { return trap.nodes.size(); });
    return traps;
}

}  // namespace campuswalk::engine
