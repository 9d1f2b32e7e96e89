#include "engine/walkspace/space/separate_grounds.h"

#include <algorithm>
#include <map>
#include <set>

#include "collision/geometry/disjoint_sets.h"
#include "engine/walkspace/space/node_numbers.h"

namespace campuswalk::engine {

namespace {

/// What was reached from different starts meets where nodes lie side by side: neither strode to the other's.
void join_side_by_side(const WalkSpace& space, const NodeNumbers& numbers, double apart,
                       collision::DisjointSets& sets) {
    numbers.for_each([&](const WalkNodeId& id) {
        const GridCell cell = space.cell_of(id);
        const auto y = static_cast<double>(space.node(id).y);
        for (const GridDirection& d : grid_directions()) {
            if (const auto beside = space.find({cell.x + d.x, cell.z + d.z}, y, apart)) {
                sets.join(numbers(id), numbers(*beside));
            }
        }
    });
}

}  // namespace

std::vector<SeparateGround> find_separate_grounds(const WalkSpace& space, double step_height) {
    if (space.starts.size() < 2) {
        return {};
    }
    const NodeNumbers numbers(space);
    collision::DisjointSets sets(numbers.count());
    numbers.for_each([&](const WalkNodeId& id) {
        if (const auto from = space.parent(id)) {
            sets.join(numbers(*from), numbers(id));
        }
    });
    std::set<std::uint32_t> from_starts;
    for (const WalkNodeId& start : space.starts) {
        from_starts.insert(sets.root(numbers(start)));
    }
    if (from_starts.size() > 1) {
        join_side_by_side(space, numbers, step_height + WalkNode::kLevel, sets);
    }

    std::vector<SeparateGround> grounds;
    std::map<std::uint32_t, std::size_t> ground_of;
    for (std::uint32_t i = 0; i < space.starts.size(); ++i) {
        const auto [known, is_new] = ground_of.emplace(sets.root(numbers(space.starts[i])), grounds.size());
        if (is_new) {
            grounds.emplace_back();
        }
        grounds[known->second].starts.push_back(i);
    }
    if (grounds.size() < 2) {
        return {};
    }
    numbers.for_each([&](const WalkNodeId& id) {
        if (space.node(id).hangs == 0) {
            grounds[ground_of.at(sets.root(numbers(id)))].area += space.grid.cell * space.grid.cell;
        }
    });
    return grounds;
}

}  // namespace campuswalk::engine
