#include "scene/osm/geometry/box_index.h"

#include <algorithm>
#include <cmath>

namespace campuswalk::scene::osm {

namespace {

constexpr double kMaxCells = 4096.0;  // of a box; one that covers more is near everything

}  // namespace

bool BoxIndex::is_large(const Box& box) const {
    const Point size = box.size() / cell_ + Point(1, 1);
    return !(size.x() * size.y() < kMaxCells);
}

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
    if (is_large(box)) {
        everywhere_.push_back(number);
        return;
    }
    visit(box, [&](std::int64_t key) { cells_[key].push_back(number); });
}

std::vector<std::size_t> BoxIndex::near(const Box& box) const {
    std::vector<std::size_t> found = everywhere_;
    const auto take = [&](const std::vector<std::size_t>& numbers) {
        found.insert(found.end(), numbers.begin(), numbers.end());
    };
    if (is_large(box)) {
        for (const auto& [key, numbers] : cells_) {
            take(numbers);
        }
    } else {
        visit(box, [&](std::int64_t key) {
            if (const auto cell = cells_.find(key); cell != cells_.end()) {
                take(cell->second);
            }
        });
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace campuswalk::scene::osm
