#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace campuswalk::scene {

/// The value below which such a share of the others lies, 0 to 1. `values` isn't empty.
inline double quantile(std::vector<double> values, double share) {
    std::ranges::sort(values);
    return values[std::min(values.size() - 1,
                           static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

/// The value in the middle; if there are two, the higher one. `values` isn't empty.
inline double median(std::vector<double> values) {
    return quantile(std::move(values), 0.5);
}

}  // namespace campuswalk::scene
