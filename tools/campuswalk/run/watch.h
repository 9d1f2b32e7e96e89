#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "tools/campuswalk/run/plan/run_settings.h"

namespace campuswalk::tools {

/// Runs everything, then, whenever a file changes, the walks that depend on it, as far as that is known.
/// Calls `run` with these walks, or with none for all walks, in a process of its own. Goes on until
/// interrupted; returns the exit code for that.
int watch_and_run(const RunSettings& settings,
                  const std::function<int(const std::vector<std::filesystem::path>&)>& run);

}  // namespace campuswalk::tools
