#include "engine/walkspace/traps.h"

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

/// Parts no farther apart in height than this are one pit's, metres.
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
          numbers_(space_),
          sets_(numbers_.count()),
          strider_(worlds[0], settings.strides, settings.solids),
          step_(settings.strides.body.step_height) {
        for_each_stride([&](const WalkNodeId& from, const WalkNodeId& to) {
            if (space_.node(to).returns == 1) {
                sets_.join(numbers_(to), numbers_(from));
            }
        });
        for_each_stride([&](const WalkNodeId& from, const WalkNodeId& to) {
            if (space_.node(to).returns == 0) {
                sources_[part_of(to)].insert(part_of(from));
            }
        });
        for (const WalkNodeId& start : space.starts) {
            home_.insert(part_of(start));
        }
    }

    /// Nodes by part that is no one's way home, after all ways were tried.
    std::map<std::size_t, std::vector<WalkNodeId>> without_path_home() {
        std::map<std::size_t, std::vector<WalkNodeId>> parts = others();
        for (bool changed = true; changed;) {
            changed = false;
            for (const auto& [part, nodes] : parts) {
                if (!leads_home(part) && finds_path(part, nodes)) {
                    mark_home(part);
                    changed = true;
                }
            }
        }
        for (const auto& [part, nodes] : parts) {
            if (!leads_home(part) && (finds_any_path(part, nodes) || finds_winding_path(part, nodes))) {
                mark_home(part);
            }
        }
        std::erase_if(parts, [&](const auto& part) { return leads_home(part.first); });
        return parts;
    }

private:
    /// Calls `visit(from, to)` for those that the space was explored by.
    template <typename Visit>
    void for_each_stride(const Visit& visit) const {
        numbers_.for_each([&](const WalkNodeId& to) {
            if (const auto from = space_.parent(to)) {
                visit(*from, to);
            }
        });
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
        for (const std::size_t source : sources_[part]) {
            if (!leads_home(source)) {
                mark_home(source);
            }
        }
    }

    /// Whether one that leads there leads home. If not, that is noted: it may turn out to lead home later.
    bool leads_home_into(std::size_t part, std::size_t there) {
        if (there != part) {
            sources_[there].insert(part);
        }
        return leads_home(there);
    }

    std::optional<std::size_t> part_at(const StrideEnd& end) {
        const auto node = end.kind == StrideEnd::Kind::grounded
                              ? space_.find(space_.grid.cell_at(end.at.foot), end.at.foot.y())
                              : std::nullopt;
        return node ? std::optional(part_of(*node)) : std::nullopt;
    }

    bool leads_home_by(std::size_t part, const StrideEnd& end) {
        const auto there = part_at(end);
        return there && leads_home_into(part, *there);
    }

    /// Tries where its nodes lie beside others that lead home.
    bool finds_path(std::size_t part, const std::vector<WalkNodeId>& nodes) {
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
                const GroundState at = space_.state_at(ref, strider_);
                if (leads_home_by(part, strider_.take(at, {.direction = direction}, space_.grid))) {
                    return true;
                }
                if (++tries == kTries) {
                    return false;
                }
            }
        }
        return false;
    }

    /// Every stride from every node, straight on or straight down if it falls: does one lead home?
    bool finds_any_path(std::size_t part, const std::vector<WalkNodeId>& nodes) {
        for (const WalkNodeId& ref : nodes) {
            const GroundState at = space_.state_at(ref, strider_);
            for (std::uint8_t direction = 0; direction < 8; ++direction) {
                const StrideEnd end = strider_.take(at, {.direction = direction}, space_.grid);
                if (leads_home_by(part, end)) {
                    return true;
                }
                const Stride let_go{.direction = direction, .steering = Stride::kLetGo};
                if (end.left_ground && leads_home_by(part, strider_.take(at, let_go, space_.grid))) {
                    return true;
                }
            }
        }
        return false;
    }

    /// Two legs in any directions, sliding along what is in the way: does one end where there is a way home?
    /// In a corner, no stride of a cell may lead out.
    bool finds_winding_path(std::size_t part, const std::vector<WalkNodeId>& nodes) {
        const std::size_t every = std::max<std::size_t>(1, nodes.size() / kWindingStarts);
        for (std::size_t i = 0; i < nodes.size(); i += every) {
            const GroundState start = space_.state_at(nodes[i], strider_);
            for (const GridDirection& first : grid_directions()) {
                const StrideEnd middle = walk_on(start, first);
                if (middle.kind != StrideEnd::Kind::grounded) {
                    continue;
                }
                for (const std::size_t there : parts_one_leg_from(middle.at)) {
                    if (leads_home_into(part, there)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    StrideEnd walk_on(const GroundState& from, const GridDirection& direction) {
        const double far = 2.0 * kLeg * strider_.settings().walk_speed;
        return strider_.walk_to(from, from.foot + far * direction.unit, 0.02, kLeg);
    }

    /// Bodies that stand in one cell at one height are taken for one.
    const std::set<std::size_t>& parts_one_leg_from(const GroundState& at) {
        const auto level = static_cast<int>(std::floor(at.foot.y() / WalkNode::kLevel));
        const auto [known, is_new] = one_leg_from_.try_emplace({space_.grid.cell_at(at.foot), level});
        if (is_new) {
            for (const GridDirection& direction : grid_directions()) {
                if (const auto there = part_at(walk_on(at, direction))) {
                    known->second.insert(*there);
                }
            }
        }
        return known->second;
    }

    const WalkSpace& space_;
    NodeNumbers numbers_;
    collision::DisjointSets sets_;
    Strider strider_;
    double step_;
    std::set<std::size_t> home_;
    std::map<std::size_t, std::set<std::size_t>> sources_;  ///< of each part: those that lead into it
    std::map<std::pair<GridCell, int>, std::set<std::size_t>> one_leg_from_;
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

}  // namespace campuswalk::engine
