#pragma once

#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "collision/geometry/disjoint_sets.h"
#include "engine/walkspace/stride/walk_grid.h"

namespace campuswalk::engine {

/// Joins the sets of places that lie side by side: in one cell or in two that touch, and no farther apart in
/// height than `apart`, metres.
class NeighbourJoiner {
public:
    NeighbourJoiner(collision::DisjointSets& sets, double apart) : sets_(sets), apart_(apart) {}

    void add(const GridCell& cell, double y, std::size_t set) {
        places_[cell].emplace_back(y, set);
        for (int k = 0; k < 9; ++k) {
            const auto near = places_.find({cell.x + k % 3 - 1, cell.z + k / 3 - 1});
            for (std::size_t n = 0; near != places_.end() && n < near->second.size(); ++n) {
                if (std::abs(near->second[n].first - y) <= apart_) {
                    sets_.join(set, near->second[n].second);
                }
            }
        }
    }

private:
    collision::DisjointSets& sets_;
    double apart_;
    std::map<GridCell, std::vector<std::pair<double, std::size_t>>> places_;  ///< each with its set
};

}  // namespace campuswalk::engine
