#include "engine/walkspace/passage/bottlenecks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "collision/geometry/disjoint_sets.h"
#include "engine/walkspace/space/neighbour_joiner.h"
#include "engine/walkspace/space/node_numbers.h"
#include "engine/walkspace/stride/worker_threads.h"

namespace campuswalk::engine {

namespace {

/// Passages that differ by less may count as one, metres; with so many steps at most.
constexpr double kWidthStep = 0.1;
constexpr double kMostSteps = 20.0;
/// So much wider a passage may seem from nodes before or behind a thin wall, metres.
constexpr double kSeemsWider = 0.1;
/// What is narrower by less than this is as wide as asked for, metres.
constexpr double kAsWide = 0.005;
constexpr double kLeastSide = 1.0;  // m² on each side of what is the only way

/// Narrow nodes side by side that part the ground around them.
struct Narrows {
    std::vector<std::size_t> nodes;  ///< numbers, ascending
    std::size_t narrowest = 0;
    bool is_only_path = false;
};

/// Looks at the ground as at a landscape of widths, from the widest level down: at each level, what is
/// narrower parts what is wider.
class NarrowsSearch {
public:
    NarrowsSearch(const WalkSpace& space, const std::vector<float>& widths, double step)
        : space_(space),
          widths_(widths),
          numbers_(space),
          apart_(step),
          wider_(widths.size()),
          joiner_(wider_, apart_) {
        numbers_.for_each([&](const WalkNodeId& id) { ids_.push_back(id); });
    }

    /// Of nodes narrower than `level`. Levels must fall from call to call.
    std::vector<Narrows> at_level(double level) {
        add_wider(level);
        std::vector<std::size_t> narrow;
        for (std::size_t i = 0; i < ids_.size(); ++i) {
            if (is_ground(i) && !is_wider(i)) {
                narrow.push_back(i);
            }
        }
        collision::DisjointSets sets(ids_.size());
        NeighbourJoiner joiner(sets, apart_);
        std::map<std::uint32_t, Narrows> clusters;
        for (const std::size_t i : narrow) {
            joiner.add(cell_of(i), y_of(i), i);
        }
        for (const std::size_t i : narrow) {
            clusters[sets.root(i)].nodes.push_back(i);
        }
        std::vector<Narrows> found;
        for (auto& [root, cluster] : clusters) {
            if (parts_ground(cluster)) {
                found.push_back(std::move(cluster));
            }
        }
        return found;
    }

    const WalkNodeId& id_of(std::size_t number) const { return ids_[number]; }

private:
    GridCell cell_of(std::size_t i) const { return space_.cell_of(ids_[i]); }
    double y_of(std::size_t i) const { return static_cast<double>(space_.node(ids_[i]).y); }
    bool is_ground(std::size_t i) const { return space_.node(ids_[i]).hangs == 0; }
    bool is_wider(std::size_t i) const { return static_cast<double>(widths_[i]) >= level_; }

    void add_wider(double level) {
        const double before = std::exchange(level_, level);
        for (std::size_t i = 0; i < ids_.size(); ++i) {
            if (is_ground(i) && is_wider(i) && static_cast<double>(widths_[i]) < before) {
                joiner_.add(cell_of(i), y_of(i), i);
            }
        }
        areas_.assign(ids_.size(), 0);
        for (std::size_t i = 0; i < ids_.size(); ++i) {
            ++areas_[wider_.root(i)];
        }
    }

    /// Also fills the rest of the cluster in.
    bool parts_ground(Narrows& cluster) {
        const std::vector<std::vector<std::size_t>> sides = sides_of(cluster);
        if (sides.size() < 2) {
            return false;
        }
        std::set<std::uint32_t> grounds;
        for (const std::vector<std::size_t>& side : sides) {
            const std::uint32_t ground = wider_.root(side.front());
            if (static_cast<double>(areas_[ground]) * space_.grid.cell * space_.grid.cell >= kLeastSide) {
                grounds.insert(ground);
            }
        }
        const auto width = [&](std::size_t i) { return widths_[i]; };
        cluster.narrowest = *std::ranges::min_element(cluster.nodes, {}, width);
        cluster.is_only_path = grounds.size() > 1;
        return !grounds.empty() && (cluster.is_only_path || is_round_trip(sides, grounds));
    }

    /// Whether two of the sides are of one ground: beside a pillar, not before a niche.
    bool is_round_trip(const std::vector<std::vector<std::size_t>>& sides,
                       const std::set<std::uint32_t>& grounds) {
        return std::ranges::count_if(sides, [&](const std::vector<std::size_t>& side) {
                   return grounds.contains(wider_.root(side.front()));
               }) > 1;
    }

    /// The wider nodes right beside the cluster, those side by side together.
    std::vector<std::vector<std::size_t>> sides_of(const Narrows& cluster) const {
        std::set<std::size_t> ring;
        for (const std::size_t i : cluster.nodes) {
            for (const GridDirection& to : grid_directions()) {
                const GridCell cell = cell_of(i);
                const auto beside = space_.find({cell.x + to.x, cell.z + to.z}, y_of(i), apart_);
                if (beside && is_ground(numbers_(*beside)) && is_wider(numbers_(*beside))) {
                    ring.insert(numbers_(*beside));
                }
            }
        }
        const std::vector<std::size_t> nodes(ring.begin(), ring.end());
        collision::DisjointSets sets(nodes.size());
        NeighbourJoiner joiner(sets, apart_);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            joiner.add(cell_of(nodes[i]), y_of(nodes[i]), i);
        }
        std::map<std::uint32_t, std::vector<std::size_t>> sides;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            sides[sets.root(i)].push_back(nodes[i]);
        }
        std::vector<std::vector<std::size_t>> list;
        list.reserve(sides.size());
        for (auto& [root, side] : sides) {
            list.push_back(std::move(side));
        }
        return list;
    }

    const WalkSpace& space_;
    const std::vector<float>& widths_;
    const NodeNumbers numbers_;
    const double apart_;
    std::vector<WalkNodeId> ids_;
    double level_ = 1e300;
    collision::DisjointSets wider_;  ///< of nodes that aren't narrower than the level
    NeighbourJoiner joiner_;
    std::vector<std::size_t> areas_;  ///< by root, in nodes
};

/// Where narrower ones lie within, only those.
std::vector<Narrows> innermost(const std::vector<std::vector<Narrows>>& by_level) {
    std::vector<Narrows> inner;
    std::set<std::size_t> told;
    for (auto level = by_level.rbegin(); level != by_level.rend(); ++level) {
        const std::size_t lower = inner.size();
        for (const Narrows& narrows : *level) {
            if (std::ranges::none_of(narrows.nodes, [&](std::size_t i) { return told.contains(i); })) {
                inner.push_back(narrows);
            }
        }
        for (std::size_t i = lower; i < inner.size(); ++i) {
            told.insert(inner[i].narrowest);
        }
    }
    return inner;
}

/// Where it is narrowest around the node, if it isn't as wide as asked for.
std::optional<PassageWidth> passage_at(const collision::World& world, const ExploreSettings& settings,
                                       const WalkSpace& space, const WalkNodeId& id, double width) {
    constexpr double kSeemsWiderFromFoot = 0.3;  // metres: from anywhere in the cell
    Strider strider(world, settings.strides, settings.solids);
    const auto passage =
        narrowest_near(world, settings, space.state_at(id, strider).foot, width + kSeemsWiderFromFoot);
    return passage && passage->width < width - kAsWide ? passage : std::nullopt;
}

/// By node, as passage_widths; of those that are hardly wide enough, where it is narrowest around them.
std::vector<float> widths_around(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                 const WalkSpace& space, double width) {
    const double widest = width + kSeemsWider;
    std::vector<float> widths = passage_widths(worlds, settings, space, widest);
    const NodeNumbers numbers(space);
    for_each_item(space.tiles.size(), worlds.size(), [&](std::size_t worker, std::size_t tile) {
        for (std::size_t n = 0; n < space.tiles[tile].nodes.size(); ++n) {
            const WalkNodeId id{static_cast<std::uint32_t>(tile), static_cast<std::uint16_t>(n)};
            float& own = widths[numbers(id)];
            if (own < static_cast<float>(width - kAsWide) || own >= static_cast<float>(widest)) {
                continue;
            }
            if (const auto passage = passage_at(worlds[worker], settings, space, id, width)) {
                own = static_cast<float>(passage->width);
            }
        }
    });
    return widths;
}

}  // namespace

std::vector<Bottleneck> find_bottlenecks(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                         const WalkSpace& space, double width) {
    const collision::MoverSettings& body = settings.strides.body;
    const std::vector<float> widths = widths_around(worlds, settings, space, width);
    const double step = body.step_height + collision::kHeightSlack + WalkNode::kLevel;
    NarrowsSearch search(space, widths, step);
    std::vector<std::vector<Narrows>> by_level;
    const double below = std::max(kWidthStep, (width - 2.0 * body.radius) / kMostSteps);
    const double highest = width - kAsWide;
    for (int i = 0; highest - i * below > 2.0 * body.radius; ++i) {
        by_level.push_back(search.at_level(highest - i * below));
    }
    std::vector<Bottleneck> bottlenecks;
    for (const Narrows& narrows : innermost(by_level)) {
        const WalkNodeId& id = search.id_of(narrows.narrowest);
        if (const auto passage = passage_at(worlds[0], settings, space, id, width)) {
            bottlenecks.push_back({*passage, narrows.is_only_path});
        }
    }
    std::ranges::stable_sort(bottlenecks, {}, [](const Bottleneck& bottleneck) {
        return std::floor(1e3 * bottleneck.passage.width + 0.5);  // what is alike in the order of the ground
    });
    return bottlenecks;
}

}  // namespace campuswalk::engine
