#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "scene/osm/read/map.h"

namespace campuswalk::scene::osm {

/// Finds boxes near others: a grid of squares, each with the numbers of the boxes that touch it.
class BoxIndex {
public:
    explicit BoxIndex(double cell = 32.0) : cell_(cell) {}

    void add(std::size_t number, const Box& box);
    /// Ascending, each once.
    std::vector<std::size_t> near(const Box& box) const;
    std::vector<std::size_t> at(const Point& p) const { return near({p, p}); }

private:
    bool is_large(const Box& box) const;
    template <typename Visit>
    void visit(const Box& box, const Visit& visit) const;

    double cell_;
    std::unordered_map<std::int64_t, std::vector<std::size_t>> cells_;
    std::vector<std::size_t> everywhere_;  ///< boxes so large that they aren't in cells
};

}  // namespace campuswalk::scene::osm
