#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace campuswalk::engine {

/// Adds an element. The vector grows by an eighth when it is full, and by some 100 bytes at least: doubling,
/// as push_back does, would waste much of the memory that a walk space takes.
template <typename T>
void push_tightly(std::vector<T>& elements, T element) {
    if (elements.size() == elements.capacity()) {
        constexpr std::size_t kLeast = std::max<std::size_t>(2, 96 / sizeof(T));
        elements.reserve(elements.size() + std::max(kLeast, elements.size() / 8));
    }
    elements.push_back(std::move(element));
}

}  // namespace campuswalk::engine
