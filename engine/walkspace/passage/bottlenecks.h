#pragma once

#include <vector>

#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/passage/passage_widths.h"
#include "engine/walkspace/space/walk_space.h"
#include "engine/walkspace/stride/worker_worlds.h"

namespace campuswalk::engine {

/// Where the way from one piece of ground to another is narrow.
struct Bottleneck {
    PassageWidth passage;
    /// There is no wider way round: without it, at least 1 m² on one side would be cut off from the other, or
    /// one would have to pass another bottleneck that is about as narrow or narrower.
    bool is_only_path = false;
};

/// Passages of the reached ground, through which the body fits, that are narrower than `width` (metres, more
/// than the body's own), the narrowest (by the millimetre) first: also those that lie behind one another, or
/// beside a wider one. What is narrow all along counts once, where it is the narrowest; niches that lead
/// nowhere don't count. By passage_widths: what is much lower than half the body makes nothing narrow.
std::vector<Bottleneck> find_bottlenecks(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                         const WalkSpace& space, double width);

}  // namespace campuswalk::engine
