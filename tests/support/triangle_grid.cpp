#include "tests/support/triangle_grid.h"

#include <algorithm>

namespace campuswalk::support {

void TriangleGrid::add(std::size_t object, const Vertices& t) {
    entries_.push_back({t, t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2]), object});
}

void TriangleGrid::sort_into_columns() {
    if (entries_.empty()) {
        return;
    }
    low_ = entries_.front().min;
    Point high = entries_.front().max;
    for (const Entry& e : entries_) {
        low_ = low_.cwiseMin(e.min);
        high = high.cwiseMax(e.max);
    }
    size_ = ((high - low_) / static_cast<double>(kColumns)).cwiseMax(1.0);
    columns_.assign(kColumns * kColumns, {});
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const Entry& e = entries_[i];
        for (std::size_t z = column_of(e.min.z(), 2); z <= column_of(e.max.z(), 2); ++z) {
            for (std::size_t x = column_of(e.min.x(), 0); x <= column_of(e.max.x(), 0); ++x) {
                columns_[z * kColumns + x].push_back(i);
            }
        }
    }
}

std::size_t TriangleGrid::column_of(double coordinate, int axis) const {
    const double column = (coordinate - low_[axis]) / size_[axis];
    return static_cast<std::size_t>(std::clamp(column, 0.0, static_cast<double>(kColumns - 1)));
}

}  // namespace campuswalk::support
