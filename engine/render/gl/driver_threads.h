#pragma once

#include <cstddef>

namespace campuswalk::engine::render {

/// Tells Mesa's software driver that so many processes of this machine draw at the same time, this being one
/// of them, so that together they start no more threads than there are processors. To be called before the
/// first context is made; what the user says by LP_NUM_THREADS stays.
void share_processors(std::size_t processes);

}  // namespace campuswalk::engine::render
