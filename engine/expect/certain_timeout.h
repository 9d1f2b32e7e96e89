#pragma once

#include <vector>

#include "engine/script/walk.h"

namespace campuswalk::engine {

/// A time that the walk's steps exceed whatever happens. An xfail of that failure can't be wrong.
struct CertainTimeout {
    SourceMark mark;        ///< of the step, or of the walk's status
    const char* code = "";  ///< of the failure: a walk_to or follow that takes too long is `blocked`
};

/// Steps to whose target the straight line alone takes longer than they may take, and the walk, if its steps
/// wait, turn and go for longer than it may take.
std::vector<CertainTimeout> certain_timeouts(const Walk& walk);

}  // namespace campuswalk::engine
