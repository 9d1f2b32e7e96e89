#pragma once

#include <cstddef>

namespace campuswalk::collision {

/// Starts to load the first `bytes` of something that will soon be read.
template <typename Part>
inline void prefetch(const Part& part, std::size_t bytes = sizeof(Part)) {
    for (std::size_t at = 0; at < bytes; at += 64) {
        __builtin_prefetch(reinterpret_cast<const char*>(&part) + at);
    }
}

}  // namespace campuswalk::collision
