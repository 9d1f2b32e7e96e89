#pragma once

#include <cstddef>
#include <functional>

namespace campuswalk::scene {

/// Does `work(0)` to `work(count - 1)`, up to `most` at a time in threads of their own; comes back when all
/// are done. For what mostly waits for other processes. `work` throws nothing.
void parallel_for(std::size_t count, std::size_t most, const std::function<void(std::size_t)>& work);

}  // namespace campuswalk::scene
