#pragma once

#include <vector>

#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Heights at which much of the solids' surface is level and faces up: floors and roofs, from below, at least
/// a storey apart; where to cut a campus open. Always at least one. Unlike engine/walkspace/space/storeys.h
/// it takes no walking, and knows of no way to them.
std::vector<double> floor_heights(const scene::Campus& campus);

}  // namespace campuswalk::engine
