#pragma once

#include <string>
#include <string_view>

#include "engine/report/run_plan.h"
#include "tools/campuswalk/run/plan/plan.h"

namespace campuswalk::tools {

/// What the results of all shards of a run depend on. `options`: those of the command line and of
/// walks.config.yaml, as text. Reads every input of the plan, each once.
engine::RunFingerprint run_fingerprint(const Plan& plan, std::string_view options);

/// Identifies what this process does of a run: two runs with the same text play the same cases, from the same
/// files, with the same build. `options`: what the saved results depend on besides the fingerprint's.
std::string resume_fingerprint(const engine::RunPlan& plan, std::string_view options);

}  // namespace campuswalk::tools
