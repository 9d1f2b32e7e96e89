#pragma once

#include <cstddef>
#include <vector>

#include "scene/lint/level_patches.h"

namespace campuswalk::scene {

/// Treads that follow one another alike, whatever the unit.
struct StairRhythm {
    std::size_t risers = 0;
    double riser = 0.0;  ///< in the model's metres, the median
    double going = 0.0;  ///< from one edge to the next in plan, the median
};

/// Looks for four or more level surfaces of one shape, each above and behind the one before by the same rise
/// and going, as steep as stairs are: a rise of 0.35 to 0.85 of the going. In order of their first treads.
std::vector<StairRhythm> stair_rhythms(const std::vector<LevelPatch>& patches);

}  // namespace campuswalk::scene
