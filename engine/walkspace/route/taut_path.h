#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "engine/walkspace/route/guessed_path.h"

namespace campuswalk::engine {

/// The spots on a straight line, from a body's feet on: of all cells that it crosses but those that it just
/// cuts, from one to the next no farther up or down than guessed paths go. None if there is none in two cells
/// in a row, where the rules forbid one, or if the body would touch something on its way or pass it by less
/// than `beside`, metres.
std::optional<std::vector<GroundMap::Spot>> straight_path(GroundMap& map, const collision::Vec3& from,
                                                          const collision::Vec3& to, const GuessRules& rules,
                                                          double beside = 0.0);

/// The largest number up to `most` for which something works, found by ever larger leaps and then by halving
/// the one after the last that worked. It does for 1, which isn't asked. What doesn't work for a number may
/// work for larger ones: round a column, one sees nothing for a while.
template <typename Works>
std::size_t farthest_by_leaps(std::size_t most, const Works& works) {
    std::size_t good = 1;
    std::size_t bad = most + 1;
    for (std::size_t last = 1; last < most;) {
        const std::size_t next = std::min(2 * last, most);
        if (works(next)) {
            good = next;
            bad = most + 1;
        } else {
            bad = std::min(bad, next);
        }
        last = next;
    }
    while (good + 1 < bad) {
        const std::size_t middle = good + (bad - good) / 2;
        (works(middle) ? good : bad) = middle;
    }
    return good;
}

/// A path over the map as a string would lie that is pulled at both ends: straight wherever straight_path
/// leads on. Tight places aren't cared for.
std::vector<GroundMap::Spot> pulled_taut(GroundMap& map, std::vector<GroundMap::Spot> path,
                                         const GuessRules& rules);

}  // namespace campuswalk::engine
