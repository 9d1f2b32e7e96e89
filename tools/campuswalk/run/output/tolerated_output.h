#pragma once

#include "tools/campuswalk/run/output/output_folder.h"
#include "tools/campuswalk/run/plan/plan.h"
#include "tools/campuswalk/run/plan/run_settings.h"

namespace campuswalk::tools {

/// What a run may find in its output folder: anything, but where CI is set only what it may have left there
/// itself. `continues`: it goes on with a run that was killed, before that could list what it had written.
OutputFolder::Tolerance tolerated_output(const RunSettings& settings, const Plan& plan, bool continues);

}  // namespace campuswalk::tools
