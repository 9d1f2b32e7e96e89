#pragma once

#include <vector>

#include "scene/lint/model_report.h"

namespace campuswalk::tools {

/// Prints a line for each, and below it where it is: five places at most.
void print_lints(const std::vector<scene::ModelLint>& lints);

}  // namespace campuswalk::tools
