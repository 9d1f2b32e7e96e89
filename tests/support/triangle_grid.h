#pragma once

#include <cstddef>
#include <vector>

#include "tests/support/plain_geometry.h"

namespace campuswalk::support {

/// Triangles in square columns over x and z.
class TriangleGrid {
public:
    struct Entry {
        Vertices vertices;
        Point min = Point::Zero();
        Point max = Point::Zero();
        std::size_t object = 0;
    };

    void add(std::size_t object, const Vertices& triangle);
    /// Call once, after the last `add`.
    void sort_into_columns();

    const std::vector<Entry>& entries() const { return entries_; }

    /// Calls `visit(entry)` for every triangle whose bounds overlap the box from `min` to `max`, possibly
    /// more than once for one that spans several columns.
    template <typename Visit>
    void visit_near(const Point& min, const Point& max, const Visit& visit) const {
        if (columns_.empty()) {
            return;
        }
        for (std::size_t z = column_of(min.z(), 2); z <= column_of(max.z(), 2); ++z) {
            for (std::size_t x = column_of(min.x(), 0); x <= column_of(max.x(), 0); ++x) {
                for (const std::size_t i : columns_[z * kColumns + x]) {
                    const Entry& e = entries_[i];
                    if ((e.min.array() <= max.array()).all() && (min.array() <= e.max.array()).all()) {
                        visit(e);
                    }
                }
            }
        }
    }

private:
    /// Per side; enough for a campus of half a kilometre in columns of a metre.
    static constexpr std::size_t kColumns = 512;

    std::size_t column_of(double coordinate, int axis) const;

    std::vector<Entry> entries_;
    std::vector<std::vector<std::size_t>> columns_;
    Point low_ = Point::Zero();
    Point size_ = Point::Ones();  ///< of a column
};

}  // namespace campuswalk::support
