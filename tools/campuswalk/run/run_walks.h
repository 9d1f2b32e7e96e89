#pragma once

#include "tools/campuswalk/run/plan/run_options.h"

namespace campuswalk::tools {

/// Finds, reads and checks the selected walks, then plays those without errors. Returns the exit code.
int run_walks(const RunOptions& options);

}  // namespace campuswalk::tools
