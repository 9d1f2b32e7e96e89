#pragma once

#include "engine/report/walk_result.h"

namespace campuswalk::engine {

/// One with every field other than its default.
WalkResult full_result();

}  // namespace campuswalk::engine
