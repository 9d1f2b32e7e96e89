#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "engine/walkspace/walk_grid.h"

namespace campuswalk::engine {

/// Sets of the numbers 0 to `count - 1` that are joined one by one (union-find). A set is known by its lowest
/// number.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }

    std::size_t root(std::size_t i) {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }
    void join(std::size_t a, std::size_t b) {
        const auto [low, high] = std::minmax({root(a), root(b)});
        parent_[high] = low;
    }

private:
    std::vector<std::size_t> parent_;
};

/// Joins the sets of places that lie side by side: in one cell or in two that touch, and no farther apart in
/// height than `apart`, metres.
class NeighbourJoiner {
public:
    NeighbourJoiner(DisjointSets& sets, double apart) : sets_(sets), apart_(apart) {}

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
    DisjointSets& sets_;
    double apart_;
    std::map<GridCell, std::vector<std::pair<double, std::size_t>>> places_;  ///< each with its set
};

}  // namespace campuswalk::engine
