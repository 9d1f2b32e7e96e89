#pragma once

#include "tools/campuswalk/run/plan/run_options.h"

namespace campuswalk::tools {

/// Finds, reads and checks all walks that are wanted, then plays those that are in order. Returns the exit
/// code.
int run_walks(const RunOptions& options);

}  // namespace campuswalk::tools
