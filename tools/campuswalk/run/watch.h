#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "tools/campuswalk/run/plan/run_settings.h"

namespace campuswalk::tools {

/// Runs everything, then, whenever a file changes, the walks that are made from it, as far as that is known
/// (dependencies.h). `run` is called with those walks, with none for all of them, in a process of its own.
/// Until interrupted; returns the exit code for that.
int watch_and_run(const RunSettings& settings,
                  const std::function<int(const std::vector<std::filesystem::path>&)>& run);

}  // namespace campuswalk::tools
