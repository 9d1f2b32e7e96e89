#pragma once

#include <cstddef>
#include <vector>

#include "tools/campuswalk_bench/engine/engine.h"
#include "tools/campuswalk_bench/procedural/walk_course.h"

namespace campuswalk::tools::bench {

/// The end of a tick of a walk.
struct WalkTick {
    collision::Vec3 foot = collision::Vec3::Zero();
    double us = 0.0;  ///< microseconds, with one reading of the clock
};

/// A walk along a path.
struct WalkRecord {
    collision::Vec3 start = collision::Vec3::Zero();  ///< where the walker was placed
    std::vector<WalkTick> ticks;
    std::vector<char> arrived;    ///< by goal
    std::size_t heap_growth = 0;  ///< bytes, from the start to the end
};

/// A record with enough memory reserved for any walk along this path.
WalkRecord empty_record(const WalkPath& path, const WalkBody& body);

/// Walks towards one goal after the other and records which are reached, within 0.2 m. Each goal has a time
/// limit: 1.6 times the straight walk plus 2 s, or, if it is forbidden, the straight walk plus 3 s.
void walk_path(WalkEngine& engine, const WalkPath& path, const WalkBody& body, WalkRecord& record);

}  // namespace campuswalk::tools::bench
