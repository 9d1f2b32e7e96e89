#pragma once

#include <cstddef>
#include <functional>

namespace campuswalk::engine {

/// Calls `work(worker, item)` once for each item from 0 to `items - 1`, on up to `workers` threads, each with
/// a number of its own below `workers`, and waits for all of them. Which worker takes an item is left to
/// chance: results must not depend on it. An exception ends the call once all workers have stopped, and is
/// thrown again.
void for_each_item(std::size_t items, std::size_t workers,
                   const std::function<void(std::size_t worker, std::size_t item)>& work);

}  // namespace campuswalk::engine
