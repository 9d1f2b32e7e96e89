#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace campuswalk::engine {

/// Adds an element. The vector grows by an eighth when it is full: doubling, as push_back does, would waste
/// much of the memory that a walk space takes.
template <typename T>
void push_tightly(std::vector<T>& elements, T element) {
    if (elements.size() == elements.capacity()) {
        elements.reserve(elements.size() + std::max<std::size_t>(8, elements.size() / 8));
    }
    elements.push_back(std::move(element));
}

}  // namespace campuswalk::engine
