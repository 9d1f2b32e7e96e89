#include "scene/osm/box_index.h"

#include <algorithm>
#include <cmath>

namespace campuswalk::scene::osm {

namespace {

constexpr double kMaxCells = 1024.0;  // of a box, along an edge

}  // namespace

template <typename Visit>
void BoxIndex::visit(const Box& box, const Visit& visit) const {
    const auto cell = [&](double value) { return static_cast<std::int64_t>(std::floor(value / cell_)); };
    for (std::int64_t y = cell(box.min.y()); y <= cell(box.max.y()); ++y) {
        for (std::int64_t x = cell(box.min.x()); x <= cell(box.max.x()); ++x) {
            visit(y * 1'000'003 + x);
        }
    }
}

void BoxIndex::add(std::size_t number, const Box& box) {
    if (!(box.size().maxCoeff() < kMaxCells * cell_)) {
        everywhere_.push_back(number);
        return;
    }
    visit(box, [&](std::int64_t key) { cells_[key].push_back(number); });
}

std::vector<std::size_t> BoxIndex::near(const Box& box) const {
    std::vector<std::size_t> found = everywhere_;
    visit(box, [&](std::int64_t key) {
        if (const auto cell = cells_.find(key); cell != cells_.end()) {
            found.insert(found.end(), cell->second.begin(), cell->second.end());
        }
    });
    std::ranges::sort(found);
    const auto repeated = std::ranges::unique(found);
    found.erase(repeated.begin(), repeated.end());
    return found;
}

}  // namespace campuswalk::scene::osm
