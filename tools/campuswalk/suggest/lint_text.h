#pragma once

#include <vector>

#include "scene/lint/model_report.h"

namespace campuswalk::tools {

/// Prints one line per lint and, below it, up to five places.
void print_lints(const std::vector<scene::ModelLint>& lints);

}  // namespace campuswalk::tools
