#pragma once

#include <string>
#include <string_view>

#include "tools/campuswalk/run/plan/plan.h"

namespace campuswalk::tools {

/// Identifies everything that the results of a run depend on, by content: the program, `settings`, and the
/// YAML files, models, textures and golden files of the cases.
std::string run_fingerprint(const Plan& plan, std::string_view settings);

}  // namespace campuswalk::tools
