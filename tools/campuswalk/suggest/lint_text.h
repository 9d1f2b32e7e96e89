#pragma once

#include <vector>

#include "scene/lint/model_report.h"
#include "tools/campuswalk/suggest/upright_model.h"

namespace campuswalk::tools {

/// What is left out of the ground and of what is solid, a lint for each kind.
std::vector<scene::ModelLint> intangible_lints(const UprightModel& upright);

/// Prints one line per lint and, below it, up to five places.
void print_lints(const std::vector<scene::ModelLint>& lints);

}  // namespace campuswalk::tools
