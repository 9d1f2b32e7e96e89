#pragma once

#include <cstddef>

namespace campuswalk::engine::render {

/// Limits the threads of Mesa's software driver so that `processes` processes drawing at once, this one
/// included, don't exceed the number of processors. Call before the first context is made; an LP_NUM_THREADS
/// set by the user takes precedence.
void share_processors(std::size_t processes);

}  // namespace campuswalk::engine::render
