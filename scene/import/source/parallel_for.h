#pragma once

#include <cstddef>
#include <functional>

namespace campuswalk::scene {

/// Calls `work(0)` to `work(count - 1)` on up to `max_threads` threads and waits for all of them. Meant for
/// work that waits for other processes. `work` must not throw.
void parallel_for(std::size_t count, std::size_t max_threads, const std::function<void(std::size_t)>& work);

}  // namespace campuswalk::scene
