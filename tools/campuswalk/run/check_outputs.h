#pragma once

#include "tools/campuswalk/run/plan/plan.h"
#include "tools/campuswalk/run/plan/run_settings.h"

namespace campuswalk::tools {

/// Reports what can't be written before the walks, not after their first minute, and before anything is
/// overwritten: throws scene::InputError. `images`: pictures will be drawn.
void check_outputs(const RunOptions& options, const RunSettings& settings, const Plan& plan, bool images);

}  // namespace campuswalk::tools
