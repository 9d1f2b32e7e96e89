#pragma once

#include <string>

#include "engine/script/walk.h"

namespace campuswalk::engine {

/// Why a walk did not pass: a step that gave up or an expectation that was not met.
struct Failure {
    SourceMark mark;   ///< the step or expectation in the walk file
    std::string code;  ///< "blocked", "enclosed", "fell", "timeout", "sequence", "never", "count", "reaches"
    std::string message;
};

}  // namespace campuswalk::engine
