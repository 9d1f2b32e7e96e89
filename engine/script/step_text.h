#pragma once

#include <string>

#include "engine/script/step.h"

namespace campuswalk::engine {

/// A step on one line as a walk file has it, without its details: `walk_to: desk`, `turn: 90`. Steps that
/// `repeat` and `include` unrolled can be told apart by it.
std::string text_of(const Step& step);

}  // namespace campuswalk::engine
