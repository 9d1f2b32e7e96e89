#pragma once

#include <vector>

#include "engine/walkspace/explore.h"
#include "engine/walkspace/walk_space.h"
#include "engine/walkspace/worker_worlds.h"

namespace campuswalk::engine {

/// For each node, by its number (NodeNumbers), how much room there is between what is beside a visitor on the
/// one side and what is on the other, from half its height upwards, metres: the width of the passage that the
/// node is in. Steps, low things and ceilings make no place narrow, nor do walls that meet in a corner. At
/// least the body's own width, at most `widest`.
std::vector<float> passage_widths(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                  const WalkSpace& space, double widest);

}  // namespace campuswalk::engine
