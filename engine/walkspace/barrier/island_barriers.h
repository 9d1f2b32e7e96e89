#pragma once

#include <optional>
#include <vector>

#include "engine/walkspace/barrier/why_not.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/explore/unreached_ground.h"
#include "engine/walkspace/stride/worker_worlds.h"

namespace campuswalk::engine {

/// Why each of the first `count` islands isn't reached; none where nothing that is reached lies near it. The
/// space must have its rim (ExploreSettings::keep_rim). The islands share the workers. `nodes`: what the
/// objects' meshes consist of. `wanted`, by island: whether to look for stairs, ramps and passages to it that
/// begin as far as 12 m away as well, which takes up to half a second; none is for no island.
std::vector<std::optional<Barrier>> find_island_barriers(
    const WorkerWorlds& worlds, const ExploreSettings& settings, const WalkSpace& reached,
    const std::vector<Island>& islands, std::size_t count, const scene::NodeTriangles* nodes = nullptr,
    const std::vector<bool>& wanted = {});

}  // namespace campuswalk::engine
