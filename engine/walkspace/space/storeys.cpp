#include "engine/walkspace/space/storeys.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "collision/geometry/disjoint_sets.h"
#include "engine/walkspace/space/node_numbers.h"

namespace campuswalk::engine {

namespace {

/// Neighbours whose heights differ by no more are one level floor, metres.
constexpr double kFlat = 0.03;
/// A floor belongs to the highest storey that this share of it reaches.
constexpr double kShare = 0.1;
/// A storey has at least this much ground, m².
constexpr double kLeastArea = 10.0;
constexpr std::size_t kMostStoreys = 255;

/// For each node of the tile, how many floors lie below it.
std::vector<std::uint8_t> floors_below(const WalkTile& tile) {
    std::vector<std::uint8_t> floors(tile.nodes.size(), 0);
    std::vector<std::pair<float, std::uint16_t>> column;
    for (std::uint32_t cell = 0; cell < WalkTile::kCells * WalkTile::kCells; ++cell) {
        const std::uint16_t newest = tile.newest[cell];
        column.clear();
        for (std::uint16_t i = newest; i != WalkNode::kNone; i = tile.nodes[i].next) {
            column.emplace_back(tile.nodes[i].y, i);
        }
        std::ranges::sort(column);
        std::size_t below = 0;
        for (std::size_t i = 0, floor = 0; i < column.size(); ++i) {
            if (static_cast<double>(column[i].first - column[floor].first) >= kLeastStoreyHeight) {
                below = std::min(below + 1, kMostStoreys - 1);
                floor = i;
            }
            floors[column[i].second] = static_cast<std::uint8_t>(below);
        }
    }
    return floors;
}

/// Joins neighbours on a level floor.
collision::DisjointSets level_floors(const WalkSpace& space, const NodeNumbers& numbers) {
    collision::DisjointSets floors(numbers.count());
    numbers.for_each([&](const WalkNodeId& id) {
        const GridCell cell = space.cell_of(id);
        const double y = static_cast<double>(space.node(id).y);
        for (const GridCell& beside : {GridCell{cell.x + 1, cell.z}, GridCell{cell.x, cell.z + 1}}) {
            if (const auto other = space.find(beside, y, kFlat)) {
                floors.join(numbers(id), numbers(*other));
            }
        }
    });
    return floors;
}

/// By level floor, how many of its nodes are above how many others; empty where there is none.
using StoreyCounts = std::vector<std::vector<std::size_t>>;

std::size_t storey_of(const std::vector<std::size_t>& counts) {
    const std::size_t total = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
    std::size_t storey = counts.size() - 1;
    while (storey > 0 && static_cast<double>(counts[storey]) < kShare * static_cast<double>(total)) {
        --storey;
    }
    return storey;
}

/// Storeys of a few square metres, such as the top of a table, belong to the one below.
std::vector<std::size_t> numbers_without_small(const std::vector<std::size_t>& nodes, double cell_area) {
    std::vector<std::size_t> numbers;
    std::size_t next = 0;
    for (const std::size_t count : nodes) {
        const bool own = numbers.empty() || static_cast<double>(count) * cell_area >= kLeastArea;
        numbers.push_back(own ? next++ : next - 1);
    }
    return numbers;
}

void describe(const WalkSpace& space, const NodeNumbers& numbers, Storeys& storeys) {
    std::vector<std::map<int, std::size_t>> heights(storeys.list.size());
    numbers.for_each([&](const WalkNodeId& id) {
        Storey& own = storeys.list[storeys.of(id)];
        const double y = static_cast<double>(space.node(id).y);
        own.low = std::min(own.low, y);
        own.high = std::max(own.high, y);
        own.area += space.node(id).hangs == 0 ? space.grid.cell * space.grid.cell : 0.0;
        ++heights[storeys.of(id)][static_cast<int>(std::floor(10.0 * y + 0.5))];
    });
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const auto most = std::ranges::max_element(heights[i], {}, [](const auto& h) { return h.second; });
        storeys.list[i].main_height = most == heights[i].end() ? 0.0 : 0.1 * most->first;
    }
}

}  // namespace

std::size_t storey_at_height(const Storeys& storeys, double y) {
    constexpr double kAround = 0.6;
    constexpr double kOutside = 1e6;
    std::size_t best = 0;
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < storeys.list.size(); ++i) {
        const Storey& s = storeys.list[i];
        const double outside = std::max({s.low - kAround - y, y - s.high - kAround, 0.0});
        const double apart = std::abs(s.main_height - y) + (outside > 0.0 ? kOutside * outside : 0.0);
        if (apart < least) {
            least = apart;
            best = i;
        }
    }
    return best;
}

std::optional<WalkNodeId> node_near(const WalkSpace& space, const collision::Vec3& at, double around) {
    constexpr double kFar = 1e9;
    constexpr double kHigher = 0.7;  // metres: ground that one is beside rather than below
    constexpr double kOverhead = 1e6;
    std::optional<WalkNodeId> nearest;
    double least = std::numeric_limits<double>::max();
    for (const WalkNodeId& node : space.nodes_in(
             {{at.x() - around, -kFar, at.z() - around}, {at.x() + around, kFar, at.z() + around}})) {
        const collision::Vec3 foot = space.position(node);
        const double apart = (foot - at).norm() + (foot.y() > at.y() + kHigher ? kOverhead : 0.0);
        if (apart < least) {
            least = apart;
            nearest = node;
        }
    }
    return nearest;
}

std::size_t storey_near(const WalkSpace& space, const Storeys& storeys, const collision::Vec3& at) {
    for (const double around : {2.0, 8.0, 32.0}) {
        if (const auto node = node_near(space, at, around)) {
            return storeys.of(*node);
        }
    }
    return storey_at_height(storeys, at.y());
}

Storeys find_storeys(const WalkSpace& space) {
    Storeys storeys;
    for (const WalkTile& tile : space.tiles) {
        storeys.of_nodes.push_back(floors_below(tile));
    }
    const NodeNumbers numbers(space);
    collision::DisjointSets floors = level_floors(space, numbers);
    StoreyCounts counts(numbers.count());
    numbers.for_each([&](const WalkNodeId& id) {
        std::vector<std::size_t>& count = counts[floors.root(numbers(id))];
        count.resize(std::max<std::size_t>(count.size(), storeys.of(id) + 1), 0);
        ++count[storeys.of(id)];
    });
    std::vector<std::size_t> nodes;
    numbers.for_each([&](const WalkNodeId& id) {
        const std::size_t storey = storey_of(counts[floors.root(numbers(id))]);
        storeys.of_nodes[id.tile][id.node] = static_cast<std::uint8_t>(storey);
        nodes.resize(std::max(nodes.size(), storey + 1), 0);
        nodes[storey] += space.node(id).hangs == 0 ? 1U : 0U;
    });
    const std::vector<std::size_t> renumbered =
        numbers_without_small(nodes, space.grid.cell * space.grid.cell);
    for (std::vector<std::uint8_t>& tile : storeys.of_nodes) {
        for (std::uint8_t& storey : tile) {
            storey = static_cast<std::uint8_t>(renumbered[storey]);
        }
    }
    storeys.list.resize(renumbered.empty() ? 0 : renumbered.back() + 1);
    describe(space, numbers, storeys);
    return storeys;
}

}  // namespace campuswalk::engine
