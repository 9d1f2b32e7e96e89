#pragma once

#include <optional>

#include "engine/script/walk.h"

namespace campuswalk::engine {

/// Where a time is written that the walk's steps exceed whatever happens: a step's, of whose target the
/// straight line alone takes longer at `fastest` metres per second, or that of the walk, in which the steps
/// wait, turn and go for longer. An xfail of such a `timeout` can't be wrong.
std::optional<SourceMark> certain_timeout(const Walk& walk, double fastest);

}  // namespace campuswalk::engine
