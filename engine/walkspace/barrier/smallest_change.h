#pragma once

#include <vector>

#include "engine/walkspace/barrier/why_not.h"

namespace campuswalk::engine {

/// A change that would let the body through, as the barrier that it overcomes.
struct Change {
    Barrier barrier;
    double size = 0.0;    ///< of the object to take away, the diagonal of its bounds, metres; else 0
    double length = 0.0;  ///< of the whole way without the object, metres; else 0
};

/// A climb that is a smaller change than to take away a node.
bool is_small_climb(const Change& change);

/// The smallest of at least one, with the others as its parts, the smaller first. Of objects the smallest,
/// rather a door than the wall beside it, and of those of about one size the one without which the way is
/// much shorter.
Barrier smallest_of(std::vector<Change> changes);

}  // namespace campuswalk::engine
