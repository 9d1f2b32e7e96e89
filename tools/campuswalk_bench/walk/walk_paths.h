#pragma once

#include <cstddef>
#include <vector>

#include "tools/campuswalk_bench/engine/engine.h"
#include "tools/campuswalk_bench/procedural/walk_course.h"

namespace campuswalk::tools::bench {

/// A tick of a walk, at its end.
struct WalkTick {
    collision::Vec3 foot = collision::Vec3::Zero();
    double us = 0.0;  ///< what it took, with one reading of the clock
};

/// What came of a path.
struct WalkRecord {
    collision::Vec3 start = collision::Vec3::Zero();  ///< where the walker was put
    std::vector<WalkTick> ticks;
    std::vector<char> arrived;    ///< by goal
    std::size_t heap_growth = 0;  ///< bytes, from the start to the end
};

/// The record of no walk along this path takes more memory than this has.
WalkRecord empty_record(const WalkPath& path, const WalkBody& body);

/// Heads for one goal after the other and says which it got to, to 0.2 m. Each has its time, whoever walks: a
/// good half more than the way takes straight ahead, or, if it is forbidden, three seconds more to try.
void walk_path(WalkEngine& engine, const WalkPath& path, const WalkBody& body, WalkRecord& record);

}  // namespace campuswalk::tools::bench
