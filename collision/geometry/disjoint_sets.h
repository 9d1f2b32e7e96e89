#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace campuswalk::collision {

/// Sets of the numbers 0 to `count - 1` that are joined one by one (union-find by path halving). A set is
/// known by its lowest number.
class DisjointSets {
public:
    /// `count` is below 2^32.
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }

    std::uint32_t root(std::size_t i) {
        auto set = static_cast<std::uint32_t>(i);
        while (parent_[set] != set) {
            set = parent_[set] = parent_[parent_[set]];
        }
        return set;
    }
    void join(std::size_t a, std::size_t b) {
        const auto [low, high] = std::minmax({root(a), root(b)});
        parent_[high] = low;
    }
    /// By number, once nothing is joined any more.
    std::vector<std::uint32_t> roots() && {
        for (std::uint32_t& set : parent_) {
            set = parent_[set];  // whose own root is known, as it is no higher
        }
        return std::move(parent_);
    }

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace campuswalk::collision
