#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/walkspace/space/walk_space.h"

namespace campuswalk::engine {

/// In which order threads work on tiles. Each changes its own tile and looks at those around it: of two side
/// by side, one always comes after the other, whatever the number of threads. All others may be worked on at
/// once.
struct TileOrder {
    std::vector<std::uint32_t> tiles;
    /// By index of `tiles`: the indices of those beside it that it comes after, all of them lower.
    std::vector<std::vector<std::size_t>> after;
};

/// `active` and all those beside them, as one may get there; the lowest ranks first.
TileOrder order_around(const std::vector<std::uint32_t>& active, const WalkSpace& space,
                       const std::function<std::uint32_t(std::uint32_t tile)>& rank_of);

}  // namespace campuswalk::engine
