#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "tools/campuswalk/run/run_settings.h"

namespace campuswalk::tools {

/// Runs everything, then again whenever a file changes: the walks that changed or, when it is another file
/// (a campus, an avatar, a model), all of them. `run` is called with the walks that changed, with none for
/// all of them, in a process of its own. Until interrupted; returns the exit code for that.
int watch_and_run(const RunSettings& settings,
                  const std::function<int(const std::vector<std::filesystem::path>&)>& run);

}  // namespace campuswalk::tools
