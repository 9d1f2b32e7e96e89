#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace campuswalk::engine::render {

/// Turns GL images, stored bottom-up, upside down. `values` holds rows of `row` values each.
template <typename Value>
void flip_rows(std::vector<Value>& values, std::size_t row) {
    if (row == 0) {
        return;
    }
    const std::size_t rows = values.size() / row;
    for (std::size_t y = 0; y < rows / 2; ++y) {
        Value* upper = values.data() + y * row;
        std::swap_ranges(upper, upper + row, values.data() + (rows - 1 - y) * row);
    }
}

}  // namespace campuswalk::engine::render
