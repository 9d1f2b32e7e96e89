#pragma once

#include <optional>
#include <vector>

#include "engine/walkspace/barrier/why_not.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/explore/unreached_ground.h"
#include "engine/walkspace/stride/worker_worlds.h"

namespace campuswalk::engine {

/// The islands, and what was asked about them: see find_island_barriers.
struct ExplainedIslands {
    const WorkerWorlds& worlds;
    const ExploreSettings& settings;
    const WalkSpace& reached;
    const std::vector<Island>& islands;
    const scene::NodeTriangles* nodes = nullptr;
    const std::vector<bool>& wanted;
};

/// Looks again for ways to islands that lie behind others: where the barriers of these can be overcome, one
/// more may lead on from there, or none. `barriers`, by island, are those that were found from reached
/// ground; they become sequences, the shortest that there are. Only of islands that are wanted or large, and
/// whose own barrier doesn't say as much. The same for any number of workers.
void find_sequences(const ExplainedIslands& all, std::vector<std::optional<Barrier>>& barriers);

}  // namespace campuswalk::engine
