#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace campuswalk::engine {

/// Works on an item, as the worker of that number.
using ItemWork = std::function<void(std::size_t worker, std::size_t item)>;

/// Calls `work(worker, item)` once for each item from 0 to `items - 1`, on up to `workers` threads, each with
/// a number of its own below `workers`, and waits for all of them. Which worker takes an item is left to
/// chance: results must not depend on it. An exception ends the call once all workers have stopped, and is
/// thrown again.
void for_each_item(std::size_t items, std::size_t workers, const ItemWork& work);

/// Likewise, each item once those that it comes after are done: `after[item]`, with lower numbers. What these
/// did is visible to it.
void for_each_item_in_order(const std::vector<std::vector<std::size_t>>& after, std::size_t workers,
                            const ItemWork& work);

}  // namespace campuswalk::engine
